package robotran.build.messages

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension

/** Generates the languages of people in the module that holds their table, `languages.md`. */
class LanguagesPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        val generate = project.tasks.register("generateLanguages", GenerateLanguages::class.java) {
            it.languages.set(project.layout.projectDirectory.file("languages.md"))
            it.outputFolder.set(project.layout.buildDirectory.dir("generated/languages"))
        }
        project.extensions.getByType(KotlinMultiplatformExtension::class.java)
            .sourceSets.getByName("commonMain").kotlin.srcDir(generate)
    }
}
