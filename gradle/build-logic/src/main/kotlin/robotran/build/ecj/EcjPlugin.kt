package robotran.build.ecj

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.tasks.SourceSetContainer
import org.gradle.api.tasks.TaskProvider
import org.gradle.language.base.plugins.LifecycleBasePlugin
import robotran.build.android.AndroidPlugin
import robotran.build.catalog
import robotran.build.teavm.CompileToWasm
import robotran.build.teavm.TeaVmPlugin

/**
 * The module that wraps the Eclipse compiler for Java: a jar for JVM and Android, and the same classes as a WebAssembly
 * module.
 */
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
        checkForAndroid(project, rewrite)
        project.tasks.named(TeaVmPlugin.COMPILE_TASK, CompileToWasm::class.java) {
            it.mainClass.set("robotran.ecj.browser.EcjModule")
            it.moduleName.set("ecj")
            // ECJ catches such exceptions for broken sources.
            it.strict.set(true)
        }
    }

    private fun checkForAndroid(project: Project, rewrite: TaskProvider<RewriteEcj>) {
        val check = project.tasks.register("checkAndroidReferences", CheckAndroidReferences::class.java) { task ->
            task.group = LifecycleBasePlugin.VERIFICATION_GROUP
            task.description = "Looks for classes and methods that Android does not have."
            task.classes.from(rewrite.map { it.rewrittenLibrary })
            task.classes.from(
                project.extensions.getByType(SourceSetContainer::class.java).getByName("main").output.classesDirs,
            )
            val sdk = project.providers.environmentVariable("ANDROID_HOME")
            task.framework.from(sdk.map { "$it/platforms/android-${AndroidPlugin.COMPILE_SDK}/android.jar" })
            task.report.set(project.layout.buildDirectory.file("reports/androidReferences.txt"))
        }
        project.tasks.named(LifecycleBasePlugin.CHECK_TASK_NAME) { it.dependsOn(check) }
    }
}
