package robotran.robolang

/** A program that is a test; [path] says where to find it. */
internal class TestProgram(val path: String, val text: String)
