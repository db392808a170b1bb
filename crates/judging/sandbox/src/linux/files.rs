//! Which files may a process reach? Landlock's rules: what no rule grants is refused.

use std::path::PathBuf;

use landlock::{
    ABI, Access, AccessFs, AccessNet, BitFlags, CompatLevel, Compatible, Ruleset, RulesetAttr,
    RulesetCreated, RulesetCreatedAttr, RulesetError, RulesetStatus, Scope, make_bitflags,
    path_beneath_rules,
};

use crate::confinement::Confinement;

/// The version whose rules are known and tried here. A kernel with an older one enforces what it knows; with none at all nothing starts.
const NEWEST: ABI = ABI::V6;

/// Takes from this process all files but those of the confinement, TCP, and signals to whoever is not confined with it.
pub(super) fn confine(confinement: &Confinement) -> Result<(), String> {
    let status = rules(confinement)
        .and_then(RulesetCreated::restrict_self)
        .map_err(|e| format!("Landlock does not confine it: {e}"))?;
    if status.ruleset == RulesetStatus::NotEnforced || !status.no_new_privs {
        return Err("Landlock does not confine it: this kernel has none, or has it switched off".to_owned());
    }
    Ok(())
}

fn rules(confinement: &Confinement) -> Result<RulesetCreated, RulesetError> {
    let list = make_bitflags!(AccessFs::{ReadDir});
    let read = make_bitflags!(AccessFs::{ReadFile | ReadDir});
    let run = make_bitflags!(AccessFs::{Execute | ReadFile | ReadDir});
    let devices = make_bitflags!(AccessFs::{MakeChar | MakeBlock | MakeSock | MakeFifo | IoctlDev | Execute});
    let write = AccessFs::from_all(NEWEST) & !devices;
    let rules = Ruleset::default()
        // Without these there is no confinement; the later ones are a second line behind the filter of system calls.
        .set_compatibility(CompatLevel::HardRequirement)
        .handle_access(AccessFs::from_all(ABI::V1))?
        .set_compatibility(CompatLevel::BestEffort)
        .handle_access(AccessFs::from_all(NEWEST))?
        .handle_access(AccessNet::from_all(NEWEST))?
        .scope(Scope::from_all(NEWEST))?
        .create()?;
    let rules = grant(rules, &confinement.listable, list)?;
    let rules = grant(rules, &confinement.readable, read)?;
    let rules = grant(rules, &confinement.executable, run)?;
    grant(rules, &confinement.writable, write)
}

/// A path that is not there is passed over: nothing is reached through it.
fn grant(
    rules: RulesetCreated,
    paths: &[PathBuf],
    access: BitFlags<AccessFs>,
) -> Result<RulesetCreated, RulesetError> {
    rules.add_rules(path_beneath_rules(paths, access))
}
