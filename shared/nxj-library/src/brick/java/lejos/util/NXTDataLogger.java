package lejos.util;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import lejos.nxt.comm.NXTConnection;

/**
 * Writes rows of values into its memory or to a stream, for a program that draws a chart of them.
 *
 * <p>It begins with its memory; sendCache sends what is there. In a world, a stream can lead to a file or, by
 * Bluetooth, to another robot. Each row begins with the milliseconds since the log began.
 */
public class NXTDataLogger implements Logger {
    private static final int ATTENTION = 0xff;
    private static final int ATTENTION_TOO = 0xab;
    private static final int TYPE = 1;
    private static final int HEADERS = 2;
    private static final int FLUSH = 3;
    private static final int COMMENT = 4;
    private static final int NOTHING = 0xff;

    private static final int MOST_COLUMNS = 255;
    private static final int SLOW = 200;
    private static final int LAST_BYTES = 100;

    private final byte[] checks = new byte[5];
    private int check = -1;

    private DataOutputStream out;
    private DataInputStream in;
    private NXTConnection connection;
    private LogCache cache;
    private boolean isCaching;
    private int type = LogColumn.DT_INTEGER;

    private LogColumn[] columns;
    private int columnsSet;
    private int column = 1;
    private boolean isNotChecked;
    private boolean isFlushed;

    private int begin;
    private int time;
    private long lastRow;
    private String comment = "";

    /** Makes one that writes into its memory. */
    public NXTDataLogger() {
        for (int i = 0; i < checks.length; i++) checks[i] = (byte) (Math.random() * 255);
        startCachingLog();
    }

    /** Begins to write to a stream; set the columns next. */
    public void startRealtimeLog(DataOutputStream out, DataInputStream in) throws IOException {
        setStreams(out, in);
        isCaching = false;
        start();
    }

    /** Begins to write to a connection; set the columns next. */
    public void startRealtimeLog(NXTConnection connection) throws IOException {
        this.connection = connection;
        startRealtimeLog(connection.openDataOutputStream(), connection.openDataInputStream());
    }

    /** Begins to write into its memory; set the columns next. */
    public void startCachingLog() {
        isCaching = true;
        cache = new LogCache();
        out = new DataOutputStream(cache);
        start();
    }

    private void start() {
        begin = (int) System.currentTimeMillis();
        columnsSet = 0;
    }

    private void setStreams(DataOutputStream out, DataInputStream in) throws IOException {
        if (out == null) throw new IOException("DataOutputStream is null");
        if (in == null) throw new IOException("DataInputStream is null");
        this.out = out;
        this.in = in;
    }

    /** Sends what was written into the memory to a stream; until it is closed, the next values go there, too. */
    public void sendCache(DataOutputStream out, DataInputStream in) throws IOException {
        if (!isCaching) throw new IllegalStateException("wrong mode");
        setStreams(out, in);
        isCaching = false;
        sendHeaders();
        setType(columns[0].getDatatype());
        int place = 0;
        while (true) {
            LogColumn next = columns[place];
            setType(next.getDatatype());
            byte[] value = cache.take(next.getSize());
            if (value == null) break;
            this.out.write(value);
            place = (place + 1) % columns.length;
        }
        command(FLUSH, NOTHING);
        isCaching = true;
    }

    /** Sends what was written into the memory to a connection. */
    public void sendCache(NXTConnection connection) throws IOException {
        this.connection = connection;
        sendCache(connection.openDataOutputStream(), connection.openDataInputStream());
    }

    /** Ends writing, and closes the streams. */
    public synchronized void stopLogging() {
        command(FLUSH, NOTHING);
        close();
    }

    /** Sets the columns, at most 255; for the memory, only once. */
    public synchronized void setColumns(LogColumn[] columnDefs) {
        if (columnDefs.length == 0 || columnDefs.length > MOST_COLUMNS) return;
        if (isCaching && columnsSet > 0) throw new UnsupportedOperationException("already called");
        columns = new LogColumn[columnDefs.length + 1];
        columns[0] = new LogColumn("milliseconds", LogColumn.DT_INTEGER, 1);
        System.arraycopy(columnDefs, 0, columns, 1, columnDefs.length);
        columnsSet++;
        if (!isCaching) sendHeaders();
        int length = 0;
        for (LogColumn each : columns) length += each.getSize();
        cache.setRowLength(length);
    }

    /** Adds a column; for the memory, only if none was set. */
    public void appendColumn(LogColumn columnDef) throws UnsupportedOperationException {
        LogColumn[] before = getColumns();
        int count = before == null ? 0 : before.length;
        LogColumn[] all = new LogColumn[count + 1];
        if (before != null) System.arraycopy(before, 0, all, 0, count);
        all[count] = columnDef;
        setColumns(all);
    }

    /** Gives the columns that were set, or null. */
    public LogColumn[] getColumns() {
        if (columns == null) return null;
        LogColumn[] own = new LogColumn[columns.length - 1];
        System.arraycopy(columns, 1, own, 0, own.length);
        return own;
    }

    /** Sets a text to be written behind the row; nothing keeps it in the memory. */
    public synchronized void writeComment(String comment) {
        if (!isCaching) this.comment = comment;
    }

    /** Writes a value into the next column of the row. */
    public synchronized void writeLog(boolean datapoint) {
        writeInt(datapoint ? 1 : 0, LogColumn.DT_BOOLEAN);
    }

    /** Writes a value into the next column of the row. */
    public synchronized void writeLog(byte datapoint) {
        writeInt(datapoint, LogColumn.DT_BYTE);
    }

    /** Writes a value into the next column of the row. */
    public synchronized void writeLog(short datapoint) {
        writeInt(datapoint, LogColumn.DT_SHORT);
    }

    /** Writes a value into the next column of the row. */
    public synchronized void writeLog(int datapoint) {
        writeInt(datapoint, LogColumn.DT_INTEGER);
    }

    /** Writes a value into the next column of the row. */
    public synchronized void writeLog(float datapoint) {
        writeInt(Float.floatToIntBits(datapoint), LogColumn.DT_FLOAT);
    }

    /** Writes a value into the next column of the row. */
    public synchronized void writeLog(long datapoint) {
        writeLong(datapoint, LogColumn.DT_LONG);
    }

    /** Writes a value into the next column of the row. */
    public synchronized void writeLog(double datapoint) {
        writeLong(Double.doubleToLongBits(datapoint), LogColumn.DT_DOUBLE);
    }

    private void writeInt(int bits, int type) {
        beginColumn(type);
        if (out == null) return;
        try {
            out.writeInt(bits);
        } catch (IOException lost) {
            close();
        }
    }

    private void writeLong(long bits, int type) {
        beginColumn(type);
        if (out == null) return;
        try {
            out.writeLong(bits);
        } catch (IOException lost) {
            close();
        }
    }

    /** Writes the time before the first column, and checks the type; after a mistake it checks no more, as in NXJ. */
    private void beginColumn(int type) {
        if (isNotChecked) return;
        if (columnsSet == 0) throw new IllegalStateException("cols not set ");
        if (column >= columns.length) throw new IllegalStateException("too many cols ");
        isNotChecked = true;
        if (column == 1) beginRow();
        if (type != columns[column].getDatatype()) throw new IllegalStateException("datatyp mismatch ");
        setType(type);
        column++;
        isNotChecked = false;
    }

    private void beginRow() {
        setType(LogColumn.DT_INTEGER);
        time = (int) System.currentTimeMillis() - begin;
        writeInt(time, LogColumn.DT_INTEGER);
        if (isFlushed || out == null) return;
        isFlushed = true;
        try {
            out.flush();
        } catch (IOException lost) {
            close();
        }
    }

    /** Ends the row, in which every column must have a value. */
    public synchronized void finishLine() throws IOException {
        if (columns == null || column != columns.length) throw new IllegalStateException("too few cols ");
        column = 1;
        if (time == 0) return;
        if (out == null) throw new IOException("null dos");
        long now = System.currentTimeMillis();
        if (lastRow != 0 && now - lastRow > SLOW) out.flush();
        lastRow = now;
        if (comment.equals("")) return;
        command(COMMENT, NOTHING);
        if (out == null) throw new IOException("null dos");
        out.writeInt(time);
        writeText(comment);
        comment = "";
    }

    private void setType(int type) {
        if (isCaching || this.type == type) return;
        this.type = type;
        command(TYPE, type);
    }

    private void sendHeaders() {
        column = 1;
        command(HEADERS, columns.length);
        for (LogColumn each : columns) {
            String text = each.getName().replace('!', ' ') + "!" + (each.isChartable() ? "y" : "n") + "!";
            writeText(text + each.getRangeAxisID());
        }
    }

    /** Writes two bytes that call for attention, one of five at random, their sum with all bits changed, and a command. */
    private void command(int command, int value) {
        check = (check + 1) % checks.length;
        byte sum = (byte) (ATTENTION + ATTENTION_TOO + checks[check]);
        write(new byte[] {(byte) ATTENTION, (byte) ATTENTION_TOO, checks[check], (byte) ~sum});
        write(new byte[] {(byte) command, (byte) value});
    }

    /** Writes a text and one to four zeros, so that the number of bytes is divisible by four. */
    private void writeText(String text) {
        byte[] padded = new byte[text.length() / 4 * 4 + 4];
        for (int i = 0; i < text.length(); i++) padded[i] = (byte) text.charAt(i);
        write(padded);
    }

    private void write(byte[] bytes) {
        if (out == null) return;
        try {
            out.write(bytes);
        } catch (IOException lost) {
            close();
        }
    }

    private void close() {
        if (out == null || in == null) return;
        try {
            out.flush();
            Delay.msDelay(LAST_BYTES);
            if (connection != null) connection.close();
            in.close();
            out.close();
        } catch (IOException lost) {
            // It is closed all the same.
        }
        in = null;
        out = null;
    }
}
