package robotran.build.mpy

import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.process.ExecOperations
import robotran.build.sha256
import java.io.ByteArrayOutputStream
import java.io.File
import javax.inject.Inject

/**
 * Gets the npm package of MicroPython's cross compiler, pinned by [lock], and copies its WebAssembly module, checked against
 * [sha256], and its licence.
 */
@CacheableTask
abstract class FetchMpyCross
    @Inject
    constructor(private val processes: ExecOperations) : DefaultTask() {
        @get:InputFile
        @get:PathSensitive(PathSensitivity.NONE)
        abstract val packageFile: RegularFileProperty

        @get:InputFile
        @get:PathSensitive(PathSensitivity.NONE)
        abstract val lock: RegularFileProperty

        @get:Input
        abstract val sha256: Property<String>

        /** Where the files stand in [outputFolder]. */
        @get:Input
        abstract val folderInside: Property<String>

        @get:OutputDirectory
        abstract val outputFolder: DirectoryProperty

        @TaskAction
        fun fetch() {
            val work = temporaryDir
            work.listFiles()?.forEach { it.deleteRecursively() }
            for (file in listOf(packageFile, lock)) file.get().asFile.let { it.copyTo(File(work, it.name)) }
            logger.lifecycle("Fetching MicroPython's cross compiler from the npm registry, once.")
            install(work)
            val found = File(work, "node_modules/@pybricks/mpy-cross-v6")
            val module = File(found, "build/$MODULE")
            if (sha256(module) != sha256.get()) throw GradleException("$MODULE is not the one that is known")
            val folder = File(outputFolder.get().asFile, folderInside.get())
            folder.deleteRecursively()
            module.copyTo(File(folder, MODULE))
            File(found, "LICENSE").copyTo(File(folder, "mpy-cross-license.txt"))
            work.listFiles()?.forEach { it.deleteRecursively() }
        }

        private fun install(work: File) {
            val words = ByteArrayOutputStream()
            val isWindows = System.getProperty("os.name").startsWith("Windows")
            val result = try {
                processes.exec {
                    it.workingDir = work
                    it.commandLine(
                        if (isWindows) "npm.cmd" else "npm",
                        "ci",
                        "--ignore-scripts",
                        "--no-audit",
                        "--no-fund",
                    )
                    it.standardOutput = words
                    it.errorOutput = words
                    it.isIgnoreExitValue = true
                }
            } catch (failure: Exception) {
                throw GradleException("Programs for hubs need npm, once: install Node.js with npm", failure)
            }
            if (result.exitValue != 0) throw GradleException("npm could not get the compiler for hubs:\n$words")
        }

        private companion object {
            const val MODULE = "mpy-cross-v6.wasm"
        }
    }
