package robotran.build.site

import org.gradle.api.DefaultTask
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import robotran.build.wasm.WasmModule
import robotran.build.wasm.withCallMarks

/** Makes modules that tell which of their functions were called, for [RecordFirstPart]. */
@CacheableTask
abstract class MarkCalls : DefaultTask() {
    /** The output of webpack and Kotlin's plugin. */
    @get:InputDirectory
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val app: DirectoryProperty

    @get:OutputDirectory
    abstract val marked: DirectoryProperty

    @TaskAction
    fun mark() {
        for (module in DividedModule.entries) {
            val original = WasmModule.read(module.fileIn(app.get().asFile).readBytes())
            marked.get().asFile.resolve("${module.stem}.wasm").writeBytes(withCallMarks(original).bytes())
        }
    }
}
