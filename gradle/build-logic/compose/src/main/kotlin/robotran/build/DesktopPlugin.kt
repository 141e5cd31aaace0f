package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.testing.Test

/** A JVM desktop application with a Compose window, and its packages. */
class DesktopPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.pluginManager.apply("robotran.jvm-app")
        project.pluginManager.apply("org.jetbrains.kotlin.plugin.compose")
        project.pluginManager.apply("org.jetbrains.compose")
        project.tasks.withType(Test::class.java).configureEach { test ->
            // Tests that open a window are skipped without a display.
            test.inputs.files(
                FindPrograms.found(project, FindPrograms.DISPLAY),
            ).withPathSensitivity(PathSensitivity.NONE)
        }
        for (type in PACKAGES) addPackage(project, type)
    }

    /** `packageDeb` and similar tasks: packages of the app for an operating system, in `build/packages`. */
    private fun addPackage(project: Project, type: String) {
        project.tasks.register(
            "package${type.replaceFirstChar(Char::uppercase)}",
            PackageDesktopApp::class.java,
        ) { task ->
            task.group = "distribution"
            task.description = "Makes a .$type of the desktop app, with a Java of its own."
            task.dependsOn("installDist")
            task.jars.set(project.layout.buildDirectory.dir("install/robotran/lib"))
            task.resources.set(project.layout.projectDirectory.dir("src/package"))
            task.type.set(type)
            task.version.set(VERSION)
            task.mainClass.set("robotran.desktop.MainKt")
            task.javaHome.set(System.getProperty("java.home"))
            task.output.set(project.layout.buildDirectory.dir("packages/$type"))
        }
    }

    private companion object {
        val PACKAGES = listOf("deb", "msi", "dmg")
        const val VERSION = "0.1.0"
    }
}
