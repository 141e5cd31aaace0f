import josx.platform.rcx.LCD;
import josx.platform.rcx.Sensor;
import josx.util.Timer;
import josx.util.TimerListener;

/** Measures the light ten times, half a second apart, and shows the average. */
public class DataLogger implements TimerListener {
    private final int[] values = new int[10];
    private int count;

    public static void main(String[] arguments) throws InterruptedException {
        Sensor.S2.activate();
        DataLogger logger = new DataLogger();
        new Timer(500, logger).start();
        synchronized (logger) {
            logger.wait();
        }
        LCD.showNumber(logger.average());
        Thread.sleep(2000);
        System.exit(0);
    }

    public synchronized void timedOut() {
        if (count == values.length) return;
        values[count] = Sensor.S2.readValue();
        LCD.showNumber(values[count]);
        count++;
        if (count == values.length) notifyAll();
    }

    private int average() {
        int sum = 0;
        for (int index = 0; index < count; index++) sum += values[index];
        return sum / count;
    }
}
