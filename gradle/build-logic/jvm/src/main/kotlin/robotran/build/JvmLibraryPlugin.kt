package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.tasks.testing.Test
import org.jetbrains.kotlin.gradle.dsl.KotlinJvmProjectExtension
import robotran.build.messages.Messages

/** A module for the JVM alone. */
class JvmLibraryPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.pluginManager.apply("org.jetbrains.kotlin.jvm")
        val libraries = catalog(project)
        project.dependencies.add("testImplementation", "org.jetbrains.kotlin:kotlin-test")
        project.dependencies.add("testImplementation", libraries.findLibrary("coroutines-test").get())
        Messages.register(project, "src/main/messages")?.let {
            project.extensions.getByType(
                KotlinJvmProjectExtension::class.java,
            ).sourceSets.getByName("main").kotlin.srcDir(it)
        }
        project.tasks.withType(Test::class.java).configureEach { it.useJUnitPlatform() }
        TestParts.registerThorough(project, "test")
        Rings.addToQuick(project, "test")
    }
}
