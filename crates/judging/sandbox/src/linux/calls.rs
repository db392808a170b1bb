//! Which system calls may a process make? A filter in the kernel, which it can never take off again.

use std::collections::BTreeMap;

use libc::c_long;
use seccompiler::{
    BackendError, BpfProgram, SeccompAction, SeccompCmpArgLen as Len, SeccompCmpOp as Op, SeccompCondition,
    SeccompFilter, SeccompRule,
};

use crate::confinement::Calls;

/// The rules by system call: any one that fits decides, and without one every call fits.
type Rules = BTreeMap<i64, Vec<SeccompRule>>;

/// No thread has a smaller stack, in bytes: so the limit of address space is one of threads too, for root as well.
const SMALLEST_STACK: u64 = 1 << 20;

/// Lets the kernel refuse, with "operation not permitted", every system call that is not among these.
pub(super) fn confine(calls: Calls) -> Result<(), String> {
    let filters = match calls {
        Calls::Any => return Ok(()),
        Calls::Computing => computing()
            .and_then(|rules| filter(rules, SeccompAction::Errno(libc::EPERM as u32), SeccompAction::Allow)),
        Calls::Building => building()
            .and_then(|rules| filter(rules, SeccompAction::Allow, SeccompAction::Errno(libc::EPERM as u32))),
    };
    // What clone3 is asked lies in memory, where no filter sees it. Whoever hears that there is none falls back to clone.
    let no_clone3 = filter(
        Rules::from([(libc::SYS_clone3, Vec::new())]),
        SeccompAction::Allow,
        SeccompAction::Errno(libc::ENOSYS as u32),
    );
    for filter in [no_clone3, filters] {
        let filter = filter.map_err(|e| format!("the filter of system calls is not right: {e}"))?;
        seccompiler::apply_filter(&filter)
            .map_err(|e| format!("seccomp does not confine it: {e}: {}", cause(&e)))?;
    }
    Ok(())
}

fn cause(error: &seccompiler::Error) -> String {
    std::error::Error::source(error).map(ToString::to_string).unwrap_or_default()
}

fn filter(
    rules: Rules,
    otherwise: SeccompAction,
    fitting: SeccompAction,
) -> Result<BpfProgram, BackendError> {
    let machine = std::env::consts::ARCH.try_into()?;
    SeccompFilter::new(rules, otherwise, fitting, machine)?.try_into()
}

/// What a program needs that computes, reads and writes what is open, and has threads.
fn computing() -> Result<Rules, BackendError> {
    let mut rules: Rules = COMPUTING.iter().map(|call| (*call, Vec::new())).collect();
    let own = u64::from(std::process::id());
    let thread = libc::CLONE_THREAD as u64;
    let empty_path = libc::AT_EMPTY_PATH as u64;
    let mut allow = |call: c_long, alternatives: Vec<SeccompRule>| rules.insert(call, alternatives);
    // No process, only threads.
    allow(libc::SYS_clone, vec![when(0, Len::Qword, Op::MaskedEq(thread), thread)?]);
    // The C library asks for a thread's stack so: without access at first, and marked as a stack.
    allow(
        libc::SYS_mmap,
        vec![
            when(1, Len::Qword, Op::Ge, SMALLEST_STACK)?,
            when(2, Len::Dword, Op::Ne, libc::PROT_NONE as u64)?,
            when(3, Len::Dword, Op::MaskedEq(libc::MAP_STACK as u64), 0)?,
        ],
    );
    // Signals to itself, which keeps its number when it becomes another program. So it can abort.
    allow(libc::SYS_kill, vec![when(0, Len::Dword, Op::Eq, own)?]);
    allow(libc::SYS_tgkill, vec![when(0, Len::Dword, Op::Eq, own)?]);
    // Files to read, as far as the rules for files let it. These do not cover a file that is opened without being read or written, which would tell its
    // size and times.
    let path = libc::O_PATH as u64;
    allow(libc::SYS_openat, vec![when(2, Len::Dword, Op::MaskedEq(path), 0)?]);
    #[cfg(target_arch = "x86_64")]
    allow(libc::SYS_open, vec![when(1, Len::Dword, Op::MaskedEq(path), 0)?]);
    // What is known of an open file, not of any path.
    allow(libc::SYS_newfstatat, vec![when(3, Len::Dword, Op::MaskedEq(empty_path), empty_path)?]);
    allow(libc::SYS_statx, vec![when(2, Len::Dword, Op::MaskedEq(empty_path), empty_path)?]);
    // To the other end of a socket that is open, nowhere else.
    allow(libc::SYS_sendto, vec![when(4, Len::Qword, Op::Eq, 0)?]);
    // Limits are read, not set.
    allow(libc::SYS_prlimit64, vec![when(2, Len::Qword, Op::Eq, 0)?]);
    allow(libc::SYS_prctl, equal(0, &[libc::PR_SET_NAME, libc::PR_GET_NAME])?);
    allow(libc::SYS_fcntl, equal(1, &[libc::F_DUPFD_CLOEXEC, libc::F_GETFD, libc::F_GETFL])?);
    Ok(rules)
}

/// What is refused to a program that may start others.
fn building() -> Result<Rules, BackendError> {
    let mut rules: Rules = NOT_BUILDING.iter().map(|call| (*call, Vec::new())).collect();
    let namespaces = [
        libc::CLONE_NEWUSER,
        libc::CLONE_NEWNS,
        libc::CLONE_NEWPID,
        libc::CLONE_NEWNET,
        libc::CLONE_NEWIPC,
        libc::CLONE_NEWUTS,
        libc::CLONE_NEWCGROUP,
    ];
    let clone = namespaces.map(|flag| when(0, Len::Qword, Op::MaskedEq(flag as u64), flag as u64));
    rules.insert(libc::SYS_clone, clone.into_iter().collect::<Result<_, _>>()?);
    // Two ends of one's own, for a new process to say that it did not start; they lead nowhere else.
    rules.insert(libc::SYS_socketpair, vec![when(0, Len::Dword, Op::Ne, libc::AF_UNIX as u64)?]);
    // To abort is a signal to oneself.
    rules.insert(libc::SYS_tgkill, vec![when(2, Len::Dword, Op::Ne, libc::SIGABRT as u64)?]);
    // Limits are read, not set: root could raise them.
    rules.insert(libc::SYS_prlimit64, vec![when(2, Len::Qword, Op::Ne, 0)?]);
    Ok(rules)
}

/// That one argument of a system call is so.
fn when(argument: u8, len: Len, op: Op, value: u64) -> Result<SeccompRule, BackendError> {
    SeccompRule::new(vec![SeccompCondition::new(argument, len, op, value)?])
}

/// That one argument is one of these.
fn equal(argument: u8, values: &[libc::c_int]) -> Result<Vec<SeccompRule>, BackendError> {
    values.iter().map(|value| when(argument, Len::Dword, Op::Eq, *value as u64)).collect()
}

/// Allowed whatever its arguments are. `execve` is among them: this process still has to become the program; of files only that one may be run.
const COMPUTING: &[c_long] = &[
    // What is open.
    libc::SYS_read,
    libc::SYS_readv,
    libc::SYS_pread64,
    libc::SYS_write,
    libc::SYS_writev,
    libc::SYS_recvfrom,
    libc::SYS_lseek,
    libc::SYS_close,
    libc::SYS_fstat,
    libc::SYS_ppoll,
    // Memory.
    libc::SYS_brk,
    libc::SYS_munmap,
    libc::SYS_mprotect,
    libc::SYS_mremap,
    libc::SYS_madvise,
    // Threads. The other filter says that there is no clone3, which counts more than this one's leave.
    libc::SYS_clone3,
    libc::SYS_futex,
    libc::SYS_set_tid_address,
    libc::SYS_set_robust_list,
    libc::SYS_rseq,
    libc::SYS_sched_yield,
    libc::SYS_sched_getaffinity,
    libc::SYS_gettid,
    libc::SYS_getpid,
    // Its own signals, and its end.
    libc::SYS_rt_sigaction,
    libc::SYS_rt_sigprocmask,
    libc::SYS_rt_sigreturn,
    libc::SYS_sigaltstack,
    libc::SYS_restart_syscall,
    libc::SYS_exit,
    libc::SYS_exit_group,
    // Time and chance.
    libc::SYS_clock_gettime,
    libc::SYS_clock_nanosleep,
    libc::SYS_nanosleep,
    libc::SYS_gettimeofday,
    libc::SYS_getrandom,
    // To become the program.
    libc::SYS_execve,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_arch_prctl,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_poll,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_time,
];

/// Refused to a program that may start others: the network, other processes, namespaces, mounts, and the kernel's own affairs.
const NOT_BUILDING: &[c_long] = &[
    // The network.
    libc::SYS_socket,
    libc::SYS_bind,
    libc::SYS_connect,
    libc::SYS_listen,
    libc::SYS_accept,
    libc::SYS_accept4,
    // Other processes. None leaves the group in which all are ended together.
    libc::SYS_kill,
    libc::SYS_tkill,
    libc::SYS_rt_sigqueueinfo,
    libc::SYS_rt_tgsigqueueinfo,
    libc::SYS_pidfd_open,
    libc::SYS_pidfd_getfd,
    libc::SYS_pidfd_send_signal,
    libc::SYS_ptrace,
    libc::SYS_process_vm_readv,
    libc::SYS_process_vm_writev,
    libc::SYS_process_madvise,
    libc::SYS_kcmp,
    libc::SYS_setsid,
    libc::SYS_setpgid,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_setrlimit,
    // The same; libc has no name for it there.
    #[cfg(target_arch = "aarch64")]
    164,
    libc::SYS_setpriority,
    // Namespaces and mounts.
    libc::SYS_unshare,
    libc::SYS_setns,
    libc::SYS_mount,
    libc::SYS_umount2,
    libc::SYS_pivot_root,
    libc::SYS_chroot,
    libc::SYS_open_tree,
    libc::SYS_move_mount,
    libc::SYS_mount_setattr,
    libc::SYS_fsopen,
    libc::SYS_fsconfig,
    libc::SYS_fsmount,
    libc::SYS_fspick,
    libc::SYS_open_by_handle_at,
    // Older kernels' rules for files do not cover it; a file that is open is cut by another call.
    libc::SYS_truncate,
    // The kernel's own affairs.
    libc::SYS_io_uring_setup,
    libc::SYS_io_uring_enter,
    libc::SYS_io_uring_register,
    libc::SYS_bpf,
    libc::SYS_perf_event_open,
    libc::SYS_userfaultfd,
    libc::SYS_keyctl,
    libc::SYS_add_key,
    libc::SYS_request_key,
    libc::SYS_init_module,
    libc::SYS_finit_module,
    libc::SYS_delete_module,
    libc::SYS_kexec_load,
    libc::SYS_reboot,
    libc::SYS_swapon,
    libc::SYS_swapoff,
    libc::SYS_acct,
    libc::SYS_quotactl,
    libc::SYS_fanotify_init,
    libc::SYS_sethostname,
    libc::SYS_setdomainname,
    libc::SYS_settimeofday,
    libc::SYS_clock_settime,
    libc::SYS_clock_adjtime,
    libc::SYS_adjtimex,
    libc::SYS_syslog,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_iopl,
    #[cfg(target_arch = "x86_64")]
    libc::SYS_ioperm,
];
