//! On which side of a split does a thing lie? Its box's centre decides, by the bin that it falls into.

use glam::Vec3A;

/// A thing by number and its box.
#[derive(Clone, Copy, Debug)]
pub(super) struct Item {
    pub(super) min: Vec3A,
    pub(super) max: Vec3A,
    pub(super) number: u32,
}

/// Places to split at along each axis, and one more.
pub(super) const BINS: usize = 16;

impl Item {
    /// Halved before they are added: the sum may not overflow.
    #[inline(always)]
    pub(super) fn center(&self) -> Vec3A {
        0.5 * self.min + 0.5 * self.max
    }
}

/// Which of equal parts of the centres' box holds a centre, on each axis.
pub(super) struct Binning {
    pub(super) origin: Vec3A,
    pub(super) bins_per_length: Vec3A,
    /// How many parts: few for few items.
    pub(super) count: usize,
}

impl Binning {
    pub(super) fn new(centers: &Bounds, items: usize) -> Self {
        let count = items.clamp(4, BINS);
        let size = centers.size();
        let per_length = Vec3A::select(size.cmpgt(Vec3A::ZERO), (count - 1) as f32 / size, Vec3A::ZERO);
        Self { origin: centers.min, bins_per_length: per_length.min(Vec3A::splat(f32::MAX)), count }
    }

    /// The number of the bin along each axis, rounded to the nearest: 2²³ more, a number ends with that of the bin.
    #[inline(always)]
    pub(super) fn bin(&self, item: &Item) -> [u32; 3] {
        const SHIFT: Vec3A = Vec3A::splat((1_u32 << 23) as f32);
        let place = (item.center() - self.origin) * self.bins_per_length + SHIFT;
        [place.x.to_bits() % BINS as u32, place.y.to_bits() % BINS as u32, place.z.to_bits() % BINS as u32]
    }
}

#[derive(Clone, Copy)]
pub(super) struct Bounds {
    pub(super) min: Vec3A,
    pub(super) max: Vec3A,
}

impl Bounds {
    pub(super) const EMPTY: Self = Self { min: Vec3A::INFINITY, max: Vec3A::NEG_INFINITY };

    #[inline(always)]
    pub(super) fn add(&mut self, min: Vec3A, max: Vec3A) {
        self.min = self.min.min(min);
        self.max = self.max.max(max);
    }

    pub(super) fn size(&self) -> Vec3A {
        self.max - self.min
    }
}

pub(super) fn joined(mut a: (Bounds, u32), b: (Bounds, u32)) -> (Bounds, u32) {
    a.0.add(b.0.min, b.0.max);
    (a.0, a.1 + b.1)
}

/// Moves the items that are on the left to the front and counts them; and the boxes around the centres of either side.
#[inline(always)]
pub(super) fn partition(items: &mut [Item], is_left: impl Fn(&Item) -> bool) -> (usize, [Bounds; 2]) {
    let (mut left, mut right) = (0, items.len());
    let mut centers = [Bounds::EMPTY; 2];
    while left < right {
        let item = &items[left];
        let center = item.center();
        if is_left(item) {
            centers[0].add(center, center);
            left += 1;
        } else {
            centers[1].add(center, center);
            right -= 1;
            items.swap(left, right);
        }
    }
    (left, centers)
}
