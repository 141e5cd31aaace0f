package robotran.documents.messages

import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class DocumentMessagesTest {
    @Test
    fun `every sentence is another one in every language`() {
        val sentences = Language.entries.map(DocumentMessages::of).flatMap {
            listOf(it.savedByNewer(), it.copiesBroken())
        }
        assertEquals(2 * Language.entries.size, sentences.toSet().size)
        assertTrue(sentences.all { it.endsWith('.') })
    }
}
