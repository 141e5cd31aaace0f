package robotran.build.teavm

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.tasks.SourceSetContainer
import org.gradle.api.tasks.TaskProvider
import robotran.build.catalog

/**
 * Compiles a Java module's source set `browser` to a WebAssembly module of exported functions. Other modules get the
 * files through the configuration [WEB_FILES] and a [WebFilesPlugin].
 */
abstract class TeaVmPlugin(private val configure: (CompileToWasm) -> Unit) : Plugin<Project> {
    override fun apply(project: Project) {
        val libraries = catalog(project)
        val teavm = toolConfiguration(project, "teavm")
        val dependencies = project.dependencies
        dependencies.add(teavm.name, libraries.findLibrary("teavm-tooling").get())

        val sourceSets = project.extensions.getByType(SourceSetContainer::class.java)
        val main = sourceSets.getByName("main")
        val browser = sourceSets.create("browser")
        dependencies.add(browser.implementationConfigurationName, main.output)
        dependencies.add(browser.implementationConfigurationName, libraries.findLibrary("teavm-jso").get())
        dependencies.add(browser.implementationConfigurationName, libraries.findLibrary("teavm-classlib").get())

        val compile = project.tasks.register("compileToWasm", CompileToWasm::class.java) {
            it.compiler.from(teavm)
            it.program.from(browser.runtimeClasspath, main.runtimeClasspath)
            it.strict.convention(false)
            it.optimizationLevel.convention("FULL")
            it.outputFolder.set(project.layout.buildDirectory.dir("web"))
            configure(it)
        }
        offer(project, compile)
    }

    private fun offer(project: Project, compile: TaskProvider<CompileToWasm>) {
        project.configurations.create(WEB_FILES) {
            it.isCanBeResolved = false
            it.isCanBeConsumed = true
            it.outgoing.artifact(compile.flatMap { task -> task.outputFolder })
        }
    }
}

/** `shared/physics` for the browser. */
class PhysicsModulePlugin :
    TeaVmPlugin({
        it.mainClass.set("robotran.physics.browser.PhysicsModule")
        it.moduleName.set("physics")
        it.wasmFunctions.set(
            listOf(
                "applyImpulse",
                "step",
                "isAtRest",
                "x",
                "y",
                "cosine",
                "sine",
                "velocityX",
                "velocityY",
                "angularVelocity",
                "contacts",
                "freeDistance",
                "ray",
                "rayBody",
                "rayMetCircle",
                "rayNormalX",
                "rayNormalY",
                "sineOf",
                "cosineOf",
                "angleOf",
            ),
        )
    })

/** `shared/ecj` for the browser. */
class EcjModulePlugin :
    TeaVmPlugin({
        it.mainClass.set("robotran.ecj.browser.EcjModule")
        it.moduleName.set("ecj")
        // ECJ catches such exceptions for broken sources.
        it.strict.set(true)
        it.optimizationLevel.set("ADVANCED")
        it.scripts.from(it.project.file("src/browser/js/ecj-worker.mjs"))
    })
