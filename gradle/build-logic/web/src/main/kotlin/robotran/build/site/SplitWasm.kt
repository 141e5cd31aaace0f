package robotran.build.site

import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import robotran.build.wasm.CalledFunctions
import robotran.build.wasm.CalledNames
import robotran.build.wasm.LargeData
import robotran.build.wasm.WasmModule
import robotran.build.wasm.WasmModuleSplitter
import robotran.build.wasm.piecesOf

/** Splits a module into the functions that the first minute of the page calls and the rest, which comes later. */
@CacheableTask
abstract class SplitWasm : DefaultTask() {
    /** The folder with the module. */
    @get:InputDirectory
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val app: DirectoryProperty

    /** Which module; see [DividedModule]. */
    @get:Input
    abstract val stem: Property<String>

    /** The folder of the lists of functions that were called; see [CalledFunctions]. */
    @get:InputDirectory
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val lists: DirectoryProperty

    /** The folder of the parts: the first, and the rest in as many pieces as it needs. */
    @get:OutputDirectory
    abstract val parts: DirectoryProperty

    @TaskAction
    fun split() {
        val divided = DividedModule.entries.first { it.stem == stem.get() }
        val bytes = divided.fileIn(app.get().asFile).readBytes()
        val module = WasmModule.read(bytes)
        val called = CalledFunctions.parse(lists.get().asFile.resolve(divided.list).readText())
        val functions = called.indicesIn(module, hexOf(sha256(bytes))) ?: throw GradleException(
            "${divided.list} belongs to another version of ${divided.stem}.wasm. " +
                "Record it again: ./gradlew :webApp:recordFirstPart",
        )
        val (cut, lateData) = LargeData.cut(module, called.unread)
        val splitter = WasmModuleSplitter(cut, functions, lateData)
        val folder = parts.get().asFile
        val names = CalledNames.namesIn(module)
        folder.listFiles().orEmpty().forEach { it.delete() }
        folder.resolve("${divided.stem}.wasm").writeBytes(splitter.first.bytes())
        piecesOf(splitter.rest, splitter.functionsOfRest.map(names::get), PIECE).forEachIndexed { number, piece ->
            val rest = piece.bytes()
            if (rest.size > COMPILED_AT_ONCE) {
                throw GradleException(
                    "A piece of ${divided.stem}.wasm has ${rest.size} bytes, more than a page compiles at once.",
                )
            }
            folder.resolve("${divided.nameOfRest(number)}.wasm").writeBytes(rest)
        }
    }

    private companion object {
        /** How many bytes of a module Chromium compiles while the page waits; `parts.js` does so only if it must. */
        const val COMPILED_AT_ONCE = 8 * 1024 * 1024

        /** Bytes. Cutting adds what the pieces share, and the shares are equal by their code alone. */
        const val PIECE = 6 * 1024 * 1024
    }
}
