package robotran.build.ecj

import org.gradle.api.Plugin
import org.gradle.api.Project
import robotran.build.catalog
import robotran.build.teavm.CompileToWasm
import robotran.build.teavm.TeaVmPlugin

/** The module that wraps the Eclipse compiler for Java: a jar for JVM and Android, and the same classes as a WebAssembly module. */
class EcjPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.pluginManager.apply(TeaVmPlugin::class.java)
        val original = TeaVmPlugin.toolConfiguration(project, "originalEcj").apply { isTransitive = false }
        project.dependencies.add(original.name, catalog(project).findLibrary("ecj").get())
        val rewrite = project.tasks.register("rewriteEcj", RewriteEcj::class.java) {
            it.library.from(original)
            it.rewrittenLibrary.set(project.layout.buildDirectory.file("ecj/ecj-in-memory.jar"))
        }
        project.dependencies.add("implementation", project.files(rewrite.map { it.rewrittenLibrary }))
        project.tasks.named(TeaVmPlugin.COMPILE_TASK, CompileToWasm::class.java) {
            it.mainClass.set("robotran.ecj.browser.EcjModule")
            it.moduleName.set("ecj")
            // ECJ catches such exceptions where a source is broken.
            it.strict.set(true)
        }
    }
}
