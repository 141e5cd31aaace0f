import lejos.nxt.SensorPort;
import lejos.nxt.SensorPortListener;
import lejos.nxt.SoundSensor;
import lejos.nxt.TouchSensor;

// sensor 1 at 0: raw 1023
// sensor 1 at 300: raw 183
// sensor 1 at 600: raw 1023
// sensor 2 at 0: raw 512
public class SensorsThatTell {
    static volatile int changes;

    public static void main(String[] arguments) throws InterruptedException {
        TouchSensor touch = new TouchSensor(SensorPort.S1);
        SoundSensor sound = new SoundSensor(SensorPort.S2);
        Thread.sleep(50);
        SensorPort.S1.addSensorPortListener(new SensorPortListener() {
            public void stateChanged(SensorPort port, int old, int now) {
                System.out.println(port.getId() + " " + old + " " + now);
                // expect 0 1023 183
                // expect 0 183 1023
                changes++;
            }
        });
        while (changes < 2) Thread.yield();
        System.out.println(touch.isPressed()); // expect false
        System.out.println(sound.readValue()); // expect 49
        sound.setDBA(true);
        System.out.println(SensorPort.S2.readValue() + " " + SensorPort.S2.readRawValue()); // expect 49 512
        SensorPort.S2.setTypeAndMode(SensorPort.TYPE_SWITCH, SensorPort.MODE_RAW);
        System.out.println(SensorPort.S2.readValue() + " " + SensorPort.S2.getType()); // expect 512 1
        SensorPort.S2.reset();
        System.out.println(SensorPort.S2.getType() + " " + SensorPort.S2.getMode()); // expect 0 0
    }
}
