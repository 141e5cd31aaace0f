package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension

/**
 * Tests that are Robolang programs: those in `src/commonTest/resources/programs` of the module, in `examples/` and in
 * `docs/robolang.md` become lists that the module's common tests can go through on every target.
 */
class TestProgramsPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        val task = project.tasks.register("generateTestPrograms", GenerateTestPrograms::class.java) {
            it.description = "Makes Kotlin of the programs that are tests."
            it.packageName.set("robotran.robolang")
            it.language.set(ProgramLanguage(extension = "robo", fence = "robolang"))
            it.programs.from(project.fileTree("src/commonTest/resources/programs"))
            it.examples.from(project.fileTree(project.rootProject.file("examples")))
            it.documents.from(project.rootProject.file("docs/robolang.md"))
            it.root.set(project.rootProject.layout.projectDirectory)
            it.destination.set(project.layout.buildDirectory.dir("generated/testPrograms"))
        }
        project.extensions.configure(KotlinMultiplatformExtension::class.java) { kotlin ->
            kotlin.sourceSets.getByName("commonTest").kotlin.srcDir(task)
        }
    }
}
