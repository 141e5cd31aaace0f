package robotran.workshop.state

/** What a file is that should be a firmware. */
enum class FirmwareKind {
    /** The firmware of leJOS 2.1. */
    LEJOS_2_1,

    /** The firmware of leJOS 3.0. */
    LEJOS_3_0,

    /** A firmware for the RCX that is none of the known ones. */
    UNKNOWN,

    /** A firmware by LEGO, which runs no programs of leJOS. */
    LEGO,

    /** No firmware for the RCX, or damaged. */
    NONE,
}
