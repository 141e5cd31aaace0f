package robotran.robolang

/** A test program; [path] is its location. */
internal class TestProgram(val path: String, val text: String)
