package robotran.ui.golden

/**
 * Pairs: every scene on every screen, every scene in every look, and every screen in every look. A fault of a screen or a
 * look shows in one of them; `thorough` compares all.
 */
class GoldenPicturesTest : GoldenScenes() {
    override fun isCompared(scene: Scene, screen: Screen, look: Look): Boolean =
        (scene.ordinal + screen.ordinal) % Look.entries.size == look.ordinal
}
