import java.io.IOException;
import java.util.EmptyQueueException;
import java.util.EmptyStackException;
import josx.platform.rcx.LCD;
import josx.robotics.StopException;

public class ThrowableMessages {
    static int length(Throwable problem) {
        return problem.getMessage() == null ? 0 : problem.getMessage().length();
    }

    public static void main(String[] arguments) {
        Throwable[] problems = {
            new Throwable("a"), new Exception("bb"), new Error("ccc"), new RuntimeException("dddd"), new ArithmeticException("e"),
            new ArrayIndexOutOfBoundsException("ff"), new ClassCastException("ggg"), new IllegalArgumentException("hhhh"),
            new IllegalStateException("i"), new IllegalMonitorStateException("jj"), new InterruptedException("kkk"),
            new NullPointerException("llll"), new NoSuchMethodError("m"), new NoClassDefFoundError("nn"), new OutOfMemoryError("ooo"),
            new StackOverflowError("pppp"), new ThreadDeath("q"), new ClassNotFoundException("rr"),
            new IOException("s"), new StopException("t"), new EmptyQueueException("u"), new EmptyStackException("v"),
        };
        int sum = 0;
        for (int index = 0; index < problems.length; index++) sum += length(problems[index]);
        LCD.showNumber(sum); // shows: 47
        LCD.showNumber(length(new Exception())); // shows: 0
        LCD.showNumber(new Error("sss").toString().length()); // shows: 3
    }
}
