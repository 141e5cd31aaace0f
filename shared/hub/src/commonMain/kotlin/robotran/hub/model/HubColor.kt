package robotran.hub.model

/**
 * The colours that Pybricks has names for.
 *
 * @property hue 0..359 degrees.
 * @property saturation 0..100.
 * @property value 0..100.
 */
enum class HubColor(val hue: Int, val saturation: Int, val value: Int) {
    NONE(0, 0, 0),
    BLACK(0, 0, 10),
    GRAY(0, 0, 50),
    WHITE(0, 0, 100),
    RED(0, 100, 100),
    BROWN(30, 100, 50),
    ORANGE(30, 100, 100),
    YELLOW(60, 100, 100),
    GREEN(120, 100, 100),
    CYAN(180, 100, 100),
    BLUE(240, 100, 100),
    VIOLET(270, 100, 100),
    MAGENTA(300, 100, 100),
    ;

    val isGrey: Boolean get() = saturation == 0

    companion object {
        /** What a colour sensor tells apart until a program says otherwise. Black is not among them. */
        val DETECTABLE: List<HubColor> = listOf(RED, YELLOW, GREEN, BLUE, WHITE, NONE)
    }
}
