package lejos.util;

import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import lejos.nxt.Button;
import lejos.nxt.LCD;
import lejos.nxt.Sound;
import lejos.nxt.comm.Bluetooth;
import lejos.nxt.comm.NXTConnection;
import lejos.nxt.comm.USB;

/** Keeps decimal numbers, and sends them when the program says so; here, another robot can receive them. */
public class Datalogger {
    private final ArrayList<Float> log = new ArrayList<Float>();

    /** Makes an empty one. */
    public Datalogger() {
    }

    /** Keeps a number. */
    public void writeLog(float v) {
        log.add(new Float(v));
    }

    /** Keeps two numbers. */
    public void writeLog(float v0, float v1) {
        writeLog(v0);
        writeLog(v1);
    }

    /** Keeps three numbers. */
    public void writeLog(float v0, float v1, float v2) {
        writeLog(v0, v1);
        writeLog(v2);
    }

    /** Keeps four numbers. */
    public void writeLog(float v0, float v1, float v2, float v3) {
        writeLog(v0, v1);
        writeLog(v2, v3);
    }

    /** Asks how to send, waits for a connection and a byte, sends how many there are and all numbers, and asks again. */
    public void transmit() {
        TextMenu menu = new TextMenu(new String[] {" USB", " Bluetooth"}, 2, "Transmit using");
        while (Button.readButtons() == 0) Thread.yield();
        boolean isUsb = menu.select() == 0;
        LCD.clear();
        LCD.drawString(isUsb ? "wait for USB" : "wait for BT", 0, 0);
        NXTConnection connection = isUsb ? USB.waitForConnection() : Bluetooth.waitForConnection();
        InputStream in = connection.openInputStream();
        DataOutputStream out = connection.openDataOutputStream();
        LCD.drawString("connected", 0, 1);
        boolean isAgain = true;
        while (isAgain) {
            send(in, out);
            LCD.clear();
            Sound.beepSequence();
            LCD.drawString("Sent " + log.size(), 0, 0);
            menu.setTitle("Resend?         ");
            menu.setItems(new String[] {"Yes", "No"});
            isAgain = menu.select() == 0;
        }
        try {
            out.close();
        } catch (IOException lost) {
            // It is closed all the same.
        }
    }

    private void send(InputStream in, DataOutputStream out) {
        try {
            LCD.clear();
            LCD.drawString("Wait for Viewer", 0, 0);
            LCD.drawInt(in.read(), 8, 1);
        } catch (IOException lost) {
            LCD.drawString("no connection", 0, 0);
        }
        LCD.clear();
        LCD.drawString("sending ", 0, 0);
        LCD.drawInt(log.size(), 4, 8, 0);
        try {
            out.writeInt(log.size());
            out.flush();
            for (Float value : log) out.writeFloat(value.floatValue());
            out.flush();
            out.close();
        } catch (IOException lost) {
            LCD.drawString("write error", 0, 0);
            LCD.refresh();
        }
    }
}
