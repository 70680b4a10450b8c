//! Typed ids, and sets of numbers: this module never reads a coordinate.

mod sets;

pub(crate) use sets::Sets;

/// What has a position in a list: every id.
pub(crate) trait Numbered: Copy {
    /// The position.
    fn number(self) -> usize;
}

macro_rules! id {
    ($(#[$doc:meta])* $vis:vis $name:ident, $letter:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        $vis struct $name(u32);

        impl $name {
            /// The id with the given index.
            ///
            /// # Panics
            /// If the index does not fit into 32 bits.
            #[must_use]
            $vis fn new(index: usize) -> Self {
                Self(u32::try_from(index).expect("more than 2^32 elements"))
            }

            /// The id with the given number.
            #[allow(dead_code, reason = "internal ids only")]
            pub(crate) const fn raw(index: u32) -> Self {
                Self(index)
            }

            /// The position of the element in its list.
            #[must_use]
            $vis const fn index(self) -> usize {
                self.0 as usize
            }
        }

        impl Numbered for $name {
            fn number(self) -> usize {
                self.index()
            }
        }

        impl std::fmt::Debug for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                write!(f, concat!($letter, "{}"), self.0)
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                std::fmt::Debug::fmt(self, f)
            }
        }
    };
}

id!(
    /// A vertex of the input graph.
    pub VertexId, "v"
);
id!(
    /// An edge of the input graph.
    pub EdgeId, "e"
);
id!(
    /// A node of the skeleton.
    pub NodeId, "n"
);
id!(
    /// An arc of the skeleton.
    pub ArcId, "a"
);
id!(
    /// A face of the skeleton.
    pub FaceId, "f"
);

id!(
    /// A triangle of the kinetic triangulation.
    pub(crate) TriangleId, "t"
);
id!(
    /// A wavefront edge.
    pub(crate) WaveId, "w"
);
id!(
    /// A wavefront vertex; its trace is an arc.
    pub(crate) TraceId, "x"
);

id!(
    /// A motorcycle of a motorcycle graph.
    pub MotorcycleId, "m"
);
id!(
    /// A meeting of motorcycles.
    pub MeetingId, "j"
);
id!(
    /// A wall that stops motorcycles.
    pub WallId, "b"
);
