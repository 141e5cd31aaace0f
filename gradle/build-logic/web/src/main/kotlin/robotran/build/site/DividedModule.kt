package robotran.build.site

import org.gradle.api.GradleException
import robotran.build.wasm.nameOfPiece
import java.io.File

/** A module of the page that is divided: its file is called [stem], and what comes later is its rest. */
internal enum class DividedModule(val stem: String) {
    /** The app. */
    APP("robotran"),

    /** Skia, which draws it. */
    SKIKO("skiko"),
    ;

    /** The list in webApp/src/first-part of the functions of the first part. */
    val list: String = "$stem.txt"

    /** The file of the piece [number] of the rest, from 0, without hash and suffix. */
    fun nameOfRest(number: Int): String = "$stem-${nameOfPiece(number)}"

    /** The files of the rest among [files], in the order of its pieces. */
    fun restsIn(files: List<SiteFile>): List<SiteFile> = generateSequence(0) { it + 1 }
        .map { number -> files.firstOrNull { it.name.startsWith("${nameOfRest(number)}.") } }
        .takeWhile { it != null }.filterNotNull().toList()

    /** The file of the module in [folder], whether or not its name contains a hash. */
    fun fileIn(folder: File): File = folder.listFiles().orEmpty().firstOrNull { isNamed(it.name) }
        ?: throw GradleException("There is no $stem.wasm in $folder.")

    private fun isNamed(file: String) = NAMED.matchEntire(file)?.groupValues?.get(1) == stem

    private companion object {
        val NAMED = Regex("""([\w-]+?)(?:\.[0-9a-f]{16})?\.wasm""")
    }
}
