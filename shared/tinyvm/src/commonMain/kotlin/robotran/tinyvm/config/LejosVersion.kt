package robotran.tinyvm.config

/** A version of leJOS for the RCX. */
enum class LejosVersion(val text: String) {
    V2_1("2.1"),
    V3_0("3.0"),
}
