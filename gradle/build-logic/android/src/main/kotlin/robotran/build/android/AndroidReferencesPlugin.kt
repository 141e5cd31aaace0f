package robotran.build.android

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.tasks.SourceSetContainer
import org.gradle.language.base.plugins.LifecycleBasePlugin
import robotran.build.Rings
import robotran.build.ecj.EcjPlugin
import robotran.build.ecj.RewriteEcj

/** Checks that the Java compiler uses only classes that Android has. */
class AndroidReferencesPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        val rewrite = project.tasks.named(EcjPlugin.REWRITE_TASK, RewriteEcj::class.java)
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
        Rings.addToAll(project, check)
    }
}
