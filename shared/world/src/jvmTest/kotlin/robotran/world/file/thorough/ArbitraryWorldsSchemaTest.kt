package robotran.world.file.thorough

import io.kotest.property.RandomSource
import io.kotest.property.arbitrary.take
import robotran.world.file.arbitraryWorlds
import robotran.world.file.countRefused
import robotran.world.file.elementOf
import kotlin.test.Test
import kotlin.test.assertTrue

/** As `WorldSchemaTest` for the world with every field, for arbitrary ones. */
class ArbitraryWorldsSchemaTest {
    @Test
    fun `what the schema refuses is refused`() {
        val refused = arbitraryWorlds().take(3, RandomSource.seeded(2005)).sumOf { countRefused(elementOf(it)) }
        assertTrue(refused > 5_000, "$refused were refused")
    }
}
