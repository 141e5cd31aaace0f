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
import robotran.build.wasm.CalledFunctions
import robotran.build.wasm.WasmModule
import java.io.File
import javax.inject.Inject

/**
 * Walks through the first minute of two pages whose modules are those of [MarkCalls], and writes the lists of the
 * functions that they have called.
 */
@DisableCachingByDefault(because = "It is run by hand, when the lists have gone stale")
abstract class RecordFirstPart
    @Inject
    constructor(processes: ExecOperations) : BrowserTask(processes) {
        /** The script that walks: it writes lines with a module's stem and a set mark's address into `CALLS`. */
        @get:InputFile
        @get:PathSensitive(PathSensitivity.NONE)
        abstract val script: RegularFileProperty

        /** The folder of the modules of which those of [page] were made. */
        @get:InputDirectory
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val app: DirectoryProperty

        /** The page for pupils. It has other functions, since binaryen merges those that are equal. */
        @get:InputDirectory
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val published: DirectoryProperty

        /** The folder of the modules of which those of [published] were made. */
        @get:InputDirectory
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val publishedApp: DirectoryProperty

        @get:Internal
        abstract val lists: DirectoryProperty

        @TaskAction
        fun record() {
            val tested = calledIn(page.get().asFile, app.get().asFile)
            val release = calledIn(published.get().asFile, publishedApp.get().asFile)
            for ((divided, called) in tested) {
                val both = called.with(release.getValue(divided))
                lists.get().asFile.resolve(divided.list).writeText("$both")
            }
        }

        /** What [site] calls, whose marked modules were made of those in [folder]. */
        private fun calledIn(site: File, folder: File): Map<DividedModule, CalledFunctions> {
            val calls = temporaryDir.resolve("calls.txt")
            calls.writeText("")
            runNode(listOf(script.get().asFile.path)) {
                it.environment("PAGE", site.path)
                it.environment("CALLS", calls.path)
            }
            val called = calls.readLines().map { it.split(" ") }.groupBy({ it[0] }) { it[1].toInt() }
            return DividedModule.entries.associateWith { divided ->
                val bytes = divided.fileIn(folder).readBytes()
                CalledFunctions.of(called.getValue(divided.stem).toSet(), WasmModule.read(bytes), hexOf(sha256(bytes)))
            }
        }
    }
