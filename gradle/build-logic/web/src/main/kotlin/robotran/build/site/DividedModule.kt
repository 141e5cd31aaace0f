package robotran.build.site

import org.gradle.api.GradleException
import java.io.File

/** A module of the page that is divided: its file is called [stem], and what comes later [rest]. */
internal enum class DividedModule(val stem: String) {
    /** The app. */
    APP("robotran"),

    /** Skia, which draws it. */
    SKIKO("skiko"),
    ;

    /** The file of the rest, without hash and suffix. */
    val rest: String = "$stem-rest"

    /** The list in webApp/src/first-part of the functions of the first part. */
    val list: String = "$stem.txt"

    /** The file of the module in [folder], whether or not its name contains a hash. */
    fun fileIn(folder: File): File = folder.listFiles().orEmpty().firstOrNull { isNamed(it.name) }
        ?: throw GradleException("There is no $stem.wasm in $folder.")

    private fun isNamed(file: String) = NAMED.matchEntire(file)?.groupValues?.get(1) == stem

    private companion object {
        val NAMED = Regex("""([\w-]+?)(?:\.[0-9a-f]{16})?\.wasm""")
    }
}
