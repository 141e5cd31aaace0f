package robotran.build.site

import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.Optional
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import robotran.build.wasm.CalledFunctions
import robotran.build.wasm.LargeData
import robotran.build.wasm.WasmModule
import robotran.build.wasm.WasmModuleSplitter

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

    /** How many bytes the rest may have; absent if any number. */
    @get:Input
    @get:Optional
    abstract val largest: Property<Long>

    /** The folder of the two parts. */
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
        val rest = splitter.rest.bytes()
        if (rest.size > largest.getOrElse(Long.MAX_VALUE)) {
            throw GradleException(
                "The rest of ${divided.stem}.wasm has ${rest.size} bytes, more than a page can compile while it waits.",
            )
        }
        folder.resolve("${divided.stem}.wasm").writeBytes(splitter.first.bytes())
        folder.resolve("${divided.rest}.wasm").writeBytes(rest)
    }
}
