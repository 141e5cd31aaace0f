package robotran.build.site

import org.gradle.api.GradleException
import java.io.File

/** The output of webpack and Kotlin's plugin in [folder]. */
internal class BuiltApp(folder: File) {
    private val atTop = folder.listFiles().orEmpty().filter { it.isFile }.sorted()

    // Kotlin's plugin also copies the modules that webpack has already bundled, and their files.
    private val bundled = atTop.filter {
        it.extension == "mjs"
    }.flatMap { listOf(it.name, "${it.nameWithoutExtension}.wasm") } +
        atTop.filter { it.extension == DATA && !SiteFile.isNamedByContent(it) }.map { it.name }

    /** The scripts, the WebAssembly modules and the files that they fetch. */
    val code: List<SiteFile> = atTop.filter { it.extension in CODE && it.name !in bundled }.map(SiteFile::of)

    /** The script that starts the app; it loads other files relative to its own URL. */
    val script: SiteFile =
        code.firstOrNull { it.content.name == MAIN } ?: throw GradleException("There is no $MAIN in $folder.")

    /** Fonts and texts, by the paths that the app requests. */
    val resources: Map<String, SiteFile> =
        folder.resolve(RESOURCES).walk().filter { it.isFile }.sorted()
            .associate { it.relativeTo(folder).invariantSeparatorsPath to SiteFile.of(it) }

    /** The files needed for the first frame. The Java compiler and the emoji font, for example, load later. */
    val neededFirst: List<SiteFile> =
        FIRST_MODULES.map(::module) + resources.filterKeys { "/$FONTS/" in it }.values

    /** The modules that are instantiated by `WebAssembly.instantiateStreaming`. */
    val streamed: List<SiteFile> = STREAMED_MODULES.map(::module)

    /** Scripts that load later, and that a worker cannot load by itself. */
    val chunksForWorkers: List<SiteFile> = COMPILER.map { chunk ->
        code.firstOrNull { it.name.startsWith("$chunk.") && it.content.extension == "js" }
            ?: throw GradleException("There is no $chunk.js in the built app.")
    }

    /** What is not part of the [streamed] modules but may be called: the pieces of each, in the same order; none if they are not split. */
    val rests: List<List<SiteFile>> = DividedModule.entries.map { it.restsIn(code) }.filter { it.isNotEmpty() }

    /** The licences of bundled code, as collected by webpack. */
    val notices: List<File> = atTop.filter { it.name.endsWith(".LICENSE.txt") }

    private fun module(stem: String): SiteFile =
        code.firstOrNull { it.name.startsWith("$stem.") && it.content.extension == "wasm" }
            ?: throw GradleException("There is no $stem.wasm in the built app.")

    private companion object {
        const val MAIN = "robotran.js"
        const val RESOURCES = "composeResources"

        /** The folder of the fonts that Compose loads on first use. */
        const val FONTS = "font"
        const val DATA = "bin"
        val CODE = listOf("js", "wasm", DATA)

        /** The classes of leJOS NXJ, and the compiler: named in the Kotlin code, and in webApp/webpack.config.d. */
        val COMPILER = listOf("ecj", "ecj-module")
        val STREAMED_MODULES = DividedModule.entries.map { it.stem }
        val FIRST_MODULES = STREAMED_MODULES + "physics"
    }
}
