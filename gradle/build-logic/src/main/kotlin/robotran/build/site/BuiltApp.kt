package robotran.build.site

import org.gradle.api.GradleException
import java.io.File

/** What webpack and Kotlin's plugin leave of the app in [folder]. */
internal class BuiltApp(folder: File) {
    private val atTop = folder.listFiles().orEmpty().filter { it.isFile }.sorted()

    // Kotlin's plugin lays the modules beside the bundle that webpack has made of them already.
    private val bundled = atTop.filter {
        it.extension == "mjs"
    }.flatMap { listOf(it.name, "${it.nameWithoutExtension}.wasm") }

    /** The scripts and the WebAssembly modules. */
    val code: List<SiteFile> =
        atTop.filter { it.extension in CODE && it.name !in bundled }.map(SiteFile::of)

    /** The script that starts the app; it fetches what it needs from where it lies itself. */
    val script: SiteFile =
        code.firstOrNull { it.content.name == MAIN } ?: throw GradleException("There is no $MAIN in $folder.")

    /** Fonts and texts, by the paths by which the app asks for them. */
    val resources: Map<String, SiteFile> =
        folder.resolve(RESOURCES).walk().filter { it.isFile }.sorted()
            .associate { it.relativeTo(folder).invariantSeparatorsPath to SiteFile.of(it) }

    /**
     * What the first picture cannot be drawn without; the compiler for Java and the font with emoji, for example, can
     * wait.
     */
    val neededFirst: List<SiteFile> =
        FIRST_MODULES.map { stem ->
            code.firstOrNull { it.name.startsWith("$stem.") && it.content.extension == "wasm" }
                ?: throw GradleException("There is no $stem.wasm in $folder.")
        } + resources.filterKeys { "/$FONTS/" in it }.values

    /** The licences of what is in the scripts, as webpack has gathered them. */
    val notices: List<File> = atTop.filter { it.name.endsWith(".LICENSE.txt") }

    private companion object {
        const val MAIN = "robotran.js"
        const val RESOURCES = "composeResources"

        /** The folder of the fonts that Compose fetches by itself, as soon as a text is set in them. */
        const val FONTS = "font"
        val CODE = listOf("js", "wasm")
        val FIRST_MODULES = listOf("robotran", "skiko", "physics")
    }
}
