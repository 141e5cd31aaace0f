package robotran.android

/** Devices for screenshots: portrait sizes in dp. */
enum class Device(private val width: Int, private val height: Int, private val density: String) {
    PHONE(411, 891, "420dpi"),
    TABLET_8_INCH(600, 960, "hdpi"),
    TABLET_11_INCH(800, 1280, "hdpi"),
    ;

    /** Robolectric's qualifiers for this device. */
    fun qualifiers(upright: Boolean, dark: Boolean = false): String {
        val size = if (upright) "w${width}dp-h${height}dp-port" else "w${height}dp-h${width}dp-land"
        return "$size${if (dark) "-night" else "-notnight"}-$density"
    }

    /** The file name of a screenshot. */
    fun pictureName(upright: Boolean) =
        "${name.lowercase().replace('_', '-')}-${if (upright) "portrait" else "landscape"}"
}
