package robotran.documents

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

class SavingProperties :
    StringSpec({
        "being killed at any byte of any write loses at most the last change, again and again" {
            checkAll(Arb.list(Arb.int(0..3_000), 1..6), Arb.list(Arb.string(0..40), 1..8)) { kills, changes ->
                val disk = MemoryKeyValueStore()
                var kept: String? = null
                for (room in kills) {
                    val repository = ProjectRepository(CuttingStore(disk, room, kills = true))
                    var tried: String? = kept
                    try {
                        for (change in changes) {
                            tried = "$room $change"
                            repository.save(workOf(tried)) shouldBe SaveResult.Saved
                            kept = tried
                        }
                    } catch (_: Killed) {
                        // The app restarts.
                    }
                    val found = (ProjectRepository(disk).read("one") as? SavedProjectResult.Found)?.work?.text
                    (found == kept || found == tried) shouldBe true
                    kept = found
                }
            }
        }

        "a full disk is told every time and never costs what was kept" {
            checkAll(Arb.int(0..4_000), Arb.list(Arb.string(0..60), 1..10)) { room, changes ->
                val disk = MemoryKeyValueStore()
                val repository = ProjectRepository(CuttingStore(disk, room, kills = false))
                var kept: String? = null
                for (change in changes) {
                    if (repository.save(workOf(change)) == SaveResult.Saved) kept = change
                    (ProjectRepository(disk).read("one") as? SavedProjectResult.Found)?.work?.text shouldBe kept
                }
            }
        }

        "any text at all in place of a copy is passed over" {
            checkAll(Arb.string(0..300)) { text ->
                val disk = MemoryKeyValueStore()
                ProjectRepository(disk).save(workOf("beep"))
                disk.write("work-one.b", text)
                disk.work().work.text shouldBe "beep"
            }
        }
    })
