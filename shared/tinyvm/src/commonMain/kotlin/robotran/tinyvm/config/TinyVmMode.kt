package robotran.tinyvm.config

/** How closely a run follows the brick. */
enum class TinyVmMode {
    /** With all quirks of the brick; each quirk that takes effect is explained. */
    BRICK,

    /** With garbage collection and the arithmetic of the Java language; a warning says where the brick would differ. */
    FORGIVING,
}
