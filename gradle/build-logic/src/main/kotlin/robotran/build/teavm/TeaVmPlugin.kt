package robotran.build.teavm

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.artifacts.Configuration
import org.gradle.api.tasks.SourceSetContainer
import org.gradle.api.tasks.TaskProvider
import org.gradle.api.tasks.compile.JavaCompile
import robotran.build.catalog

/**
 * A Java module. Its source set `main` is a jar for the JVM and Android; `browser` compiles it to a WebAssembly module
 * of exported functions. Other modules get the browser files through the configuration [WEB_FILES] and a
 * [WebFilesPlugin].
 */
class TeaVmPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.pluginManager.apply("java-library")
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

        val compile = project.tasks.register(COMPILE_TASK, CompileToWasm::class.java) {
            it.compiler.from(teavm)
            it.program.from(browser.runtimeClasspath, main.runtimeClasspath)
            it.strict.convention(false)
            it.outputFolder.set(project.layout.buildDirectory.dir("web"))
        }
        offer(project, compile)
        // The compiler may inline a constant into another file, and incremental compilation may miss the dependency.
        project.tasks.withType(JavaCompile::class.java).configureEach { it.options.isIncremental = false }
    }

    private fun offer(project: Project, compile: TaskProvider<CompileToWasm>) {
        project.configurations.create(WEB_FILES) {
            it.isCanBeResolved = false
            it.isCanBeConsumed = true
            it.outgoing.artifact(compile.flatMap { task -> task.outputFolder })
        }
    }

    companion object {
        /** The configuration that holds the folder of files for the browser. */
        const val WEB_FILES = "webFiles"

        const val COMPILE_TASK = "compileToWasm"

        /** A configuration of files that only a build task reads. */
        fun toolConfiguration(project: Project, name: String): Configuration = project.configurations.create(name) {
            it.isCanBeConsumed = false
            it.isCanBeResolved = true
        }
    }
}
