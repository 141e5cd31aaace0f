import java.util.ArrayList;
import java.util.Timer;
import java.util.TimerTask;

// only here
public class TimersAndLists {
    public static void main(String[] arguments) throws InterruptedException {
        String[] words = {"a", "b"};
        ArrayList<String> list = new ArrayList<String>(words);
        System.out.println(list.addAll(words) + " " + list.addAll(1, new String[] {"x"}) + " " + list); // expect true true [a, x, b, a, b]
        System.out.println(list.addAll(new String[0])); // expect false
        final int[] count = new int[1];
        Timer timer = new Timer("clock", true);
        TimerTask late = new TimerTask() {
            public void run() {
                count[0]++;
                if (count[0] == 1) sleep(70);
            }
        };
        timer.scheduleAtFixedRate(late, 10, 20);
        Thread.sleep(125);
        late.cancel();
        System.out.println(count[0] + " " + timer.purge() + " " + timer.purge()); // expect 6 1 0
        timer.cancel();
    }

    static void sleep(int milliseconds) {
        try {
            Thread.sleep(milliseconds);
        } catch (InterruptedException woken) {
            return;
        }
    }
}
