package robotran.tinyvm

/** How fast a program runs. */
enum class TinyVmSpeed {
    /** As fast as on a real brick. */
    BRICK,

    /** Much faster, but still in bounds: see the number of bytecodes of each millisecond. */
    UNLIMITED,
}
