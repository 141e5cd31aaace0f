package robotran.build.site

import org.gradle.api.DefaultTask
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import robotran.build.wasm.WasmModule
import robotran.build.wasm.withCallMarks

/** Makes a `skiko.wasm` that tells which of its functions were called, for [ListCalledFunctions]. */
@CacheableTask
abstract class MarkSkiko : DefaultTask() {
    /** The output of webpack and Kotlin's plugin. */
    @get:InputDirectory
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val app: DirectoryProperty

    /** The folder of the marked `skiko.wasm`. */
    @get:OutputDirectory
    abstract val marked: DirectoryProperty

    @TaskAction
    fun mark() {
        val skiko = WasmModule.read(BuiltApp(app.get().asFile).skiko.content.readBytes())
        marked.get().asFile.resolve("skiko.wasm").writeBytes(withCallMarks(skiko).bytes())
    }
}
