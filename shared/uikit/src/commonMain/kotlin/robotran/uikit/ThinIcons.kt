package robotran.uikit

/** The icons of small buttons, of thin lines. */
object ThinIcons {
    val CROSS = Icon.thin("M0 0L24 24", "M0 24L24 0")
    val PLUS = Icon.thin("M12 0L12 24", "M0 12L24 12")

    /** A curved arrow back to the left. */
    val UNDO = Icon.thin(
        "M0.48 8.64L14.4 8.64L18.96 10.08L22.32 13.2L23.04 17.28L21.12 21.12",
        "M0.48 8.64L7.2 2.4",
        "M0.48 8.64L7.2 14.88",
    )
    val REDO = Icon.thin(
        "M23.52 8.64L9.6 8.64L5.04 10.08L1.68 13.2L0.96 17.28L2.88 21.12",
        "M23.52 8.64L16.8 2.4",
        "M23.52 8.64L16.8 14.88",
    )

    /** A magnifying glass. */
    val FIND = Icon.thin(
        "M18.72 10.08L16.1893 16.1893L10.08 18.72L3.9707 16.1893L1.44 10.08",
        "M1.44 10.08L3.9707 3.9707L10.08 1.44L16.1893 3.9707L18.72 10.08",
        "M16.32 16.32L24 24",
    )

    /** Three vertical dots. */
    val MORE = Icon.thin("M12 2.88L12 3.12", "M12 12L12 12.24", "M12 21.12L12 21.36")

    /** An arrow down into a brick. */
    val SEND = Icon.thin(
        "M12 0L12 13.92L6.48 8.64",
        "M12 13.92L17.52 8.64",
        "M5.28 14.88L0.96 14.88L0.96 24L23.04 24L23.04 14.88L18.72 14.88",
    )
    val UP = Icon.thin("M2.4 16.8L12 7.2L21.6 16.8")
    val DOWN = Icon.thin("M2.4 7.2L12 16.8L21.6 7.2")
    val CHECK = Icon.thin("M1.44 13.2L8.64 20.4L22.56 4.8")

    /** A key that points to the left, with a cross in it. */
    val ERASE = Icon.thin(
        "M0 12L7.2 3.84L24 3.84L24 20.16L7.2 20.16L0 12",
        "M12 8.64L18.72 15.36",
        "M12 15.36L18.72 8.64",
    )
}
