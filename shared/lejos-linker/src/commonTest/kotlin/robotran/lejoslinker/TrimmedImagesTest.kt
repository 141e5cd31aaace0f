package robotran.lejoslinker

import robotran.language.Language
import robotran.lejoslinker.config.ImageOptions
import robotran.lejoslinker.image.ImageContents
import robotran.lejoslinker.messages.ImageMessages
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** Images without what their programs do not need. `ImageRunTest` of `shared/programs` runs them. */
class TrimmedImagesTest {
    private fun image(name: String, isTrimmed: Boolean): LejosImage {
        val options = ImageOptions(isTrimmed = isTrimmed)
        val result =
            linkLejosImage(
                Vectors.programs,
                Vectors.library,
                listOf(name),
                options,
                messages = ImageMessages.of(Language.ENGLISH),
            )
        return assertIs<ImageResult.Success>(result, name).image
    }

    private val names = Vectors.images.keys.filter { '.' !in it }

    private fun methodsOf(contents: ImageContents): Set<String> = contents.classes.flatMapTo(HashSet()) { type ->
        type.methods.map { "${type.name} ${contents.signatures[it.signature]}" }
    }

    private fun fieldsOf(contents: ImageContents): Set<String> =
        contents.staticFields.mapTo(HashSet()) { "${it.owner} ${it.name}" }

    @Test
    fun `a trimmed image holds a part of what the whole one holds`() {
        assertTrue(names.size > 15, "$names")
        for (name in names) {
            val whole = image(name, isTrimmed = false)
            val trimmed = image(name, isTrimmed = true)
            assertTrue(trimmed.bytes.size < whole.bytes.size * 2 / 3, "$name ${trimmed.bytes.size} ${whole.bytes.size}")
            val types = whole.contents.classes.associateBy { it.name }
            for (type in trimmed.contents.classes) {
                assertEquals(types.getValue(type.name).fields, type.fields, type.name)
                assertEquals(types.getValue(type.name).objectBytes, type.objectBytes, type.name)
            }
            assertEquals(emptySet(), methodsOf(trimmed.contents) - methodsOf(whole.contents), name)
            assertEquals(emptySet(), fieldsOf(trimmed.contents) - fieldsOf(whole.contents), name)
            assertEquals(emptySet(), trimmed.contents.constants.toSet() - whole.contents.constants.toSet(), name)
        }
    }

    @Test
    fun `all that answers a call of an interface stays`() {
        val trimmed = methodsOf(image("BouncerWithBehaviours", isTrimmed = true).contents)
        val whole = methodsOf(image("BouncerWithBehaviours", isTrimmed = false).contents)
        for (signature in listOf("takeControl()Z", "action()V", "suppress()V")) {
            val answers = whole.filter { it.endsWith(" $signature") && it.startsWith("BouncerWithBehaviours") }
            assertTrue(answers.size > 1, "$answers")
            assertEquals(emptySet(), answers.toSet() - trimmed)
        }
    }

    @Test
    fun `the first classes and signatures are those that the firmware knows`() {
        for (name in names) {
            val whole = image(name, isTrimmed = false).contents
            val trimmed = image(name, isTrimmed = true).contents
            assertEquals(whole.classes.take(18).map { it.name }, trimmed.classes.take(18).map { it.name })
            assertEquals(whole.signatures.take(50), trimmed.signatures.take(50))
            assertEquals(whole.entryClasses, trimmed.entryClasses)
        }
    }

    @Test
    fun `a program that nothing but main belongs to has none of the library's methods`() {
        val empty = image("FirstDrive", isTrimmed = true).contents
        val unused = methodsOf(empty).filter { it.startsWith("josx/") && "Motor" !in it && "ROM" !in it }
        assertEquals(emptyList(), unused)
    }
}
