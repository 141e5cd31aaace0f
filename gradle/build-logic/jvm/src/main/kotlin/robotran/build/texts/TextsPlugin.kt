package robotran.build.texts

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension

/** Adds the `texts { }` block of [TextsExtension] to a multiplatform module. */
class TextsPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.extensions.create("texts", TextsExtension::class.java, project)
    }
}

/** The texts of the tree that a module embeds as Kotlin constants, maps from path to text. */
open class TextsExtension(private val project: Project) {
    /**
     * Generates the constant [qualifiedName] in [sourceSet] from the files of [folder], relative to the root, whose
     * paths in it match [pattern].
     */
    fun constant(sourceSet: String, qualifiedName: String, folder: String, pattern: String) =
        generate(sourceSet, qualifiedName, folder, pattern, fence = null)

    /**
     * The same, packed: for large texts that the web page needs seldom, in a module that may use `shared/language`, which
     * unpacks them. Files whose names end in the tag of a language, such as `text.de.md`, are apart from the others.
     */
    fun packed(sourceSet: String, qualifiedName: String, folder: String, pattern: String) =
        generate(sourceSet, qualifiedName, folder, pattern, fence = null, isPacked = true)

    /**
     * Generates the constant [qualifiedName] in [sourceSet] from the Markdown blocks marked [fence], by file and line.
     */
    fun blocks(sourceSet: String, qualifiedName: String, folder: String, pattern: String, fence: String) =
        generate(sourceSet, qualifiedName, folder, pattern, fence)

    private fun generate(
        sourceSet: String,
        qualifiedName: String,
        folder: String,
        pattern: String,
        fence: String?,
        isPacked: Boolean = false,
    ) {
        val name = qualifiedName.substringAfterLast('.')
        val task =
            project.tasks.register("generate" + name.replaceFirstChar(Char::uppercase), GenerateTexts::class.java) {
                it.texts.set(
                    project.fileTree(project.rootProject.layout.projectDirectory.dir(folder)) { tree ->
                        tree.include(pattern)
                    },
                )
                it.qualifiedName.set(qualifiedName)
                it.fence.set(fence)
                it.packed.set(isPacked)
                it.outputFolder.set(project.layout.buildDirectory.dir("generated/texts/$name"))
            }
        project.extensions.getByType(
            KotlinMultiplatformExtension::class.java,
        ).sourceSets.getByName(sourceSet).kotlin.srcDir(task)
    }
}
