import lejos.nxt.Button;
import lejos.nxt.Motor;

/** Hooks run before the program ends, and daemons do not keep it. */
public class HooksAtTheEnd {
    public static void main(String[] arguments) {
        Runtime.getRuntime().addShutdownHook(new Thread() {
            @Override
            public void run() {
                System.out.println("last");
            }
        });
        Thread daemon = new Thread() {
            @Override
            public void run() {
                while (true) Thread.yield();
            }
        };
        daemon.setDaemon(true);
        daemon.start();
        Motor.A.forward();
        Button.discardEvents();
        System.out.println("first");
        System.exit(0);
    }
}

// expect first
// expect last
