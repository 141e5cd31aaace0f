package robotran.build.site

import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import robotran.build.wasm.CalledFunctions
import robotran.build.wasm.WasmModule
import robotran.build.wasm.WasmModuleSplitter

/**
 * Splits `skiko.wasm`, which draws the app, into the functions that the app has been seen to call and the rest, which
 * the page brings later.
 */
@CacheableTask
abstract class SplitSkiko : DefaultTask() {
    /** The output of webpack and Kotlin's plugin. */
    @get:InputDirectory
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val app: DirectoryProperty

    /** The functions that were called, see [CalledFunctions]. */
    @get:InputFile
    @get:PathSensitive(PathSensitivity.NONE)
    abstract val calledFunctions: RegularFileProperty

    /** The folder of `skiko.wasm` and `skiko-rest.wasm`. */
    @get:OutputDirectory
    abstract val parts: DirectoryProperty

    @TaskAction
    fun split() {
        val skiko = BuiltApp(app.get().asFile).skiko.content.readBytes()
        val list = calledFunctions.get().asFile
        val called = CalledFunctions.parse(list.readText())
        if (called.sha256 != hexOf(sha256(skiko))) {
            throw GradleException(
                "${list.name} belongs to another version of Skiko. Record it again: ./gradlew :webApp:recordSkiko",
            )
        }
        val splitter = WasmModuleSplitter(WasmModule.read(skiko), called.functions)
        val folder = parts.get().asFile
        folder.resolve("skiko.wasm").writeBytes(splitter.first.bytes())
        folder.resolve("$REST.wasm").writeBytes(splitter.rest.bytes())
    }

    internal companion object {
        /** The file of the rest, without hash and suffix. */
        const val REST = "skiko-rest"
    }
}
