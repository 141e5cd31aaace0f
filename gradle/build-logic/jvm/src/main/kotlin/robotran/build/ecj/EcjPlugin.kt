package robotran.build.ecj

import org.gradle.api.Plugin
import org.gradle.api.Project
import robotran.build.Targets
import robotran.build.catalog
import robotran.build.teavm.configureJavaModule
import robotran.build.teavm.toolConfiguration

/**
 * The module that wraps the Eclipse compiler for Java: a jar for JVM and Android, and the same classes as a WebAssembly
 * module.
 */
class EcjPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        configureJavaModule(project)
        val original = toolConfiguration(project, "originalEcj").apply { isTransitive = false }
        project.dependencies.add(original.name, catalog(project).findLibrary("ecj").get())
        val rewrite = project.tasks.register(REWRITE_TASK, RewriteEcj::class.java) {
            it.library.from(original)
            it.rewrittenLibrary.set(project.layout.buildDirectory.file("ecj/ecj-in-memory.jar"))
        }
        project.dependencies.add("implementation", project.files(rewrite.map { it.rewrittenLibrary }))
        if (Targets.of(project).wasm) project.pluginManager.apply("robotran.ecj-module")
        if (Targets.of(project).android) project.pluginManager.apply("robotran.android.references")
    }

    companion object {
        /** The task whose output is the jar that Robotran uses. */
        const val REWRITE_TASK = "rewriteEcj"
    }
}
