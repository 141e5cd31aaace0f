package lejos.util;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import lejos.nxt.comm.NXTConnection;

/** Writes rows of values: to somebody who reads at once, or into the memory, to be sent later. */
public interface Logger {
    /** Begins to write to a stream; set the columns next. */
    void startRealtimeLog(DataOutputStream out, DataInputStream in) throws IOException;

    /** Begins to write to a connection; set the columns next. */
    void startRealtimeLog(NXTConnection connection) throws IOException;

    /** Begins to keep the values in the memory; set the columns next. */
    void startCachingLog();

    /** Sends what was kept in the memory to a stream. */
    void sendCache(DataOutputStream out, DataInputStream in) throws IOException;

    /** Sends what was kept in the memory to a connection. */
    void sendCache(NXTConnection connection) throws IOException;

    /** Sets the columns; the time in milliseconds comes before them by itself. */
    void setColumns(LogColumn[] columnDefs) throws UnsupportedOperationException;

    /** Adds a column. */
    void appendColumn(LogColumn columnDef) throws UnsupportedOperationException;

    /** Gives the columns that were set, or null. */
    LogColumn[] getColumns();

    /** Sets a text to be written behind the row; nothing keeps it in the memory. */
    void writeComment(String comment);

    /** Writes a value into the next column of the row. */
    void writeLog(boolean datapoint);

    /** Writes a value into the next column of the row. */
    void writeLog(byte datapoint);

    /** Writes a value into the next column of the row. */
    void writeLog(short datapoint);

    /** Writes a value into the next column of the row. */
    void writeLog(int datapoint);

    /** Writes a value into the next column of the row. */
    void writeLog(long datapoint);

    /** Writes a value into the next column of the row. */
    void writeLog(float datapoint);

    /** Writes a value into the next column of the row. */
    void writeLog(double datapoint);

    /** Ends the row, in which every column must have a value. */
    void finishLine() throws IllegalStateException, IOException;

    /** Ends writing, and closes the streams. */
    void stopLogging();
}
