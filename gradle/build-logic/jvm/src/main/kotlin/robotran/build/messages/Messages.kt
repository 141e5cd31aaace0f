package robotran.build.messages

import org.gradle.api.Project
import org.gradle.api.tasks.TaskProvider

/** Catalogues of messages: the Markdown files in the folder `messages` of a module's sources. */
object Messages {
    /** The table of languages, from the root. */
    const val LANGUAGES = "shared/language/languages.md"

    /** The task that generates Kotlin from the catalogues in [folder], if the module has any. */
    fun register(project: Project, folder: String): TaskProvider<GenerateMessages>? {
        val catalogues = project.layout.projectDirectory.dir(folder)
        if (!catalogues.asFile.exists()) return null
        return project.tasks.register("generateMessages", GenerateMessages::class.java) { task ->
            task.catalogues.from(project.fileTree(catalogues) { it.include("*.md") })
            task.languages.set(project.rootProject.layout.projectDirectory.file(LANGUAGES))
            task.outputFolder.set(project.layout.buildDirectory.dir("generated/messages"))
        }
    }
}
