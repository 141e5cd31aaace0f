package robotran.java

import kotlin.test.assertIs

/** As much of a class library as the tests' programs need; the compiler makes it itself. */
private val LIBRARY_SOURCES = mapOf(
    "java/lang/Object.java" to
        """
        package java.lang;
        public class Object {
            public boolean equals(Object other) { return this == other; }
            public String toString() { return ""; }
            public final void wait() throws InterruptedException { }
        }
        """,
    "java/lang/String.java" to
        """
        package java.lang;
        public final class String implements java.io.Serializable {
            public native int length();
            public native char charAt(int place);
        }
        """,
    "java/lang/StringBuffer.java" to
        """
        package java.lang;
        public final class StringBuffer {
            public StringBuffer() { }
            public StringBuffer(String text) { }
            public native StringBuffer append(String text);
            public native StringBuffer append(Object value);
            public native StringBuffer append(int value);
            public native StringBuffer append(float value);
        }
        """,
    "java/lang/Throwable.java" to "package java.lang; public class Throwable { }",
    "java/lang/Exception.java" to "package java.lang; public class Exception extends Throwable { }",
    "java/lang/RuntimeException.java" to "package java.lang; public class RuntimeException extends Exception { }",
    "java/lang/InterruptedException.java" to "package java.lang; public class InterruptedException extends Exception { }",
    "java/lang/Error.java" to "package java.lang; public class Error extends Throwable { }",
    "java/lang/Cloneable.java" to "package java.lang; public interface Cloneable { }",
    "java/lang/Class.java" to "package java.lang; public final class Class { }",
    "java/io/Serializable.java" to "package java.io; public interface Serializable { }",
    "java/lang/Integer.java" to "package java.lang; public final class Integer { public Integer(int value) { } }",
    "java/lang/Math.java" to "package java.lang; public final class Math { public static native double random(); }",
    "java/lang/System.java" to "package java.lang; public final class System { public static native long currentTimeMillis(); }",
    "java/lang/Thread.java" to
        """
        package java.lang;
        public abstract class Thread {
            public abstract void run();
            public final native void start();
            public static native void sleep(long milliseconds) throws InterruptedException;
        }
        """,
    "java/util/Vector.java" to "package java.util; public class Vector { public native void addElement(Object element); }",
    "josx/platform/rcx/Motor.java" to
        """
        package josx.platform.rcx;
        public final class Motor {
            public static final Motor A = new Motor(), B = new Motor(), C = new Motor();
            private Motor() { }
            public final native void forward();
            public final native void backward();
            public final native void setPower(int power);
        }
        """,
    "josx/platform/rcx/LCD.java" to "package josx.platform.rcx; public class LCD { public static native void showNumber(int number); }",
)

private var tinyLibrary: Map<String, ByteArray>? = null

/** Compiled on first use. */
suspend fun tinyLibrary(): Map<String, ByteArray> = tinyLibrary ?: compiledLibrary().also { tinyLibrary = it }

private suspend fun compiledLibrary(): Map<String, ByteArray> {
    val sources = LIBRARY_SOURCES.map { (path, text) -> JavaSource(path, text) }
    return assertIs<CompilationResult.Compiled>(loadJavaCompiler().compile(sources, emptyMap())).classes
}
