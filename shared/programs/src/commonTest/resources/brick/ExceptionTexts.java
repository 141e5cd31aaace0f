import java.util.EmptyQueueException;
import java.util.EmptyStackException;
import josx.robotics.StopException;

/** leJOS makes 18 exceptions without a text; few have one. */
public class ExceptionTexts {
    static class Late extends IllegalStateException {
        Late() {
            super("late"); // brick error: new IllegalStateException()
        }
    }

    static class Early extends Exception {
        Early() {
            super("early");
        }
    }

    static Throwable made(int number) {
        if (number == 0) return new ArrayIndexOutOfBoundsException("text"); // brick error: ArrayIndexOutOfBoundsException
        if (number == 1) return new ClassCastException("text"); // brick error: ClassCastException
        if (number == 2) return new ClassNotFoundException("text"); // brick error: ClassNotFoundException
        if (number == 3) return new Error("text"); // brick error: Error
        if (number == 4) return new IllegalArgumentException("text"); // brick error: IllegalArgumentException
        if (number == 5) return new IllegalMonitorStateException("text"); // brick error: IllegalMonitorStateException
        if (number == 6) return new IllegalStateException("text"); // brick error: IllegalStateException
        if (number == 7) return new InterruptedException("text"); // brick error: InterruptedException
        if (number == 8) return new NoClassDefFoundError(); // brick error: new NoClassDefFoundError("text")
        if (number == 9) return new NoSuchMethodError("text"); // brick error: NoSuchMethodError
        if (number == 10) return new NullPointerException("text"); // brick error: NullPointerException
        if (number == 11) return new OutOfMemoryError("text"); // brick error: OutOfMemoryError
        if (number == 12) return new StackOverflowError("text"); // brick error: StackOverflowError
        if (number == 13) return new ThreadDeath("text"); // brick error: ThreadDeath
        if (number == 14) return new EmptyQueueException("text"); // brick error: EmptyQueueException
        if (number == 15) return new EmptyStackException("text"); // brick error: EmptyStackException
        if (number == 16) return new StopException("text"); // brick error: StopException
        if (number == 17) return new ArithmeticException("text"); // brick error: ArithmeticException
        if (number == 18) return new Throwable("text");
        if (number == 19) return new RuntimeException("text"); // brick error: RuntimeException
        if (number == 21) return new NoClassDefFoundError("text");
        if (number == 20) return new java.io.IOException("text");
        return new Early();
    }

    public static void main(String[] args) {
        made(0);
    }
}
