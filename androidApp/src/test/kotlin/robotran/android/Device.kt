package robotran.android

/** What pictures are taken on: sizes in dp, upright. */
enum class Device(private val width: Int, private val height: Int, private val density: String) {
    PHONE(411, 891, "420dpi"),
    TABLET_8_INCH(600, 960, "hdpi"),
    TABLET_11_INCH(800, 1280, "hdpi"),
    ;

    /** As Robolectric is told. */
    fun qualifiers(upright: Boolean, dark: Boolean = false): String {
        val size = if (upright) "w${width}dp-h${height}dp-port" else "w${height}dp-h${width}dp-land"
        return "$size${if (dark) "-night" else "-notnight"}-$density"
    }

    /** As the file with a picture is called. */
    fun pictureName(upright: Boolean) =
        "${name.lowercase().replace('_', '-')}-${if (upright) "portrait" else "landscape"}"
}
