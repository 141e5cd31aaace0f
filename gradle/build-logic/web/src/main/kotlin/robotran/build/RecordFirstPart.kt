package robotran.build

import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.Internal
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.process.ExecOperations
import org.gradle.work.DisableCachingByDefault
import robotran.build.site.DividedModule
import robotran.build.site.MarkCalls
import robotran.build.site.hexOf
import robotran.build.site.sha256
import robotran.build.wasm.CalledIndices
import robotran.build.wasm.CalledNames
import robotran.build.wasm.WasmModule
import javax.inject.Inject

/**
 * Walks through the first minute of a page whose modules are those of [MarkCalls], and writes the lists of the
 * functions that it has called.
 */
@DisableCachingByDefault(because = "It is run by hand, when the lists have gone stale")
abstract class RecordFirstPart
    @Inject
    constructor(processes: ExecOperations) : BrowserTask(processes) {
        /** The script that walks: it writes lines with a module's stem and the index of a function into `CALLS`. */
        @get:InputFile
        @get:PathSensitive(PathSensitivity.NONE)
        abstract val script: RegularFileProperty

        /** The output of webpack and Kotlin's plugin, of which the marked modules were made. */
        @get:InputDirectory
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val app: DirectoryProperty

        @get:Internal
        abstract val lists: DirectoryProperty

        @TaskAction
        fun record() {
            val calls = temporaryDir.resolve("calls.txt")
            calls.writeText("")
            runNode(listOf(script.get().asFile.path)) { it.environment("CALLS", calls.path) }
            val called = calls.readLines().map { it.split(" ") }.groupBy({ it[0] }) { it[1].toInt() }
            for (divided in DividedModule.entries) {
                val bytes = divided.fileIn(app.get().asFile).readBytes()
                val module = WasmModule.read(bytes)
                val functions = called.getValue(divided.stem).toSet()
                val names = CalledNames.namesIn(module)
                val list = if (names.all { it.isEmpty() }) {
                    CalledIndices(hexOf(sha256(bytes)), functions)
                } else {
                    CalledNames(functions.map { names[it] }.filter { it.isNotEmpty() }.toSet())
                }
                lists.get().asFile.resolve(divided.list).writeText("$list")
            }
        }
    }
