import java.util.EmptyQueueException;
import java.util.EmptyStackException;
import josx.robotics.StopException;

/** leJOS makes 18 exceptions without a text; four have one. */
public class ExceptionTexts {
    static class Late extends IllegalStateException {
        Late() {
            super("late"); // error: new IllegalStateException()
        }
    }

    static class Early extends Exception {
        Early() {
            super("early");
        }
    }

    static Throwable made(int number) {
        if (number == 0) return new ArrayIndexOutOfBoundsException("text"); // error: ArrayIndexOutOfBoundsException
        if (number == 1) return new ClassCastException("text"); // error: ClassCastException
        if (number == 2) return new ClassNotFoundException("text"); // error: ClassNotFoundException
        if (number == 3) return new Error("text"); // error: Error
        if (number == 4) return new IllegalArgumentException("text"); // error: IllegalArgumentException
        if (number == 5) return new IllegalMonitorStateException("text"); // error: IllegalMonitorStateException
        if (number == 6) return new IllegalStateException("text"); // error: IllegalStateException
        if (number == 7) return new InterruptedException("text"); // error: InterruptedException
        if (number == 8) return new NoClassDefFoundError("text"); // error: NoClassDefFoundError
        if (number == 9) return new NoSuchMethodError("text"); // error: NoSuchMethodError
        if (number == 10) return new NullPointerException("text"); // error: NullPointerException
        if (number == 11) return new OutOfMemoryError("text"); // error: OutOfMemoryError
        if (number == 12) return new StackOverflowError("text"); // error: StackOverflowError
        if (number == 13) return new ThreadDeath("text"); // error: ThreadDeath
        if (number == 14) return new EmptyQueueException("text"); // error: EmptyQueueException
        if (number == 15) return new EmptyStackException("text"); // error: EmptyStackException
        if (number == 16) return new StopException("text"); // error: StopException
        if (number == 17) return new ArithmeticException("text"); // error: ArithmeticException
        if (number == 18) return new Throwable("text");
        if (number == 19) return new RuntimeException("text");
        if (number == 20) return new java.io.IOException("text");
        return new Early();
    }

    public static void main(String[] args) {
        made(0);
    }
}
