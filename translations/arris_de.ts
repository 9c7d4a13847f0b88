<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>Corner</name>
    <message>
        <source>sharp</source>
        <translation>spitz</translation>
    </message>
    <message>
        <source>blunt</source>
        <translation>stumpf</translation>
    </message>
    <message>
        <source>concave</source>
        <translation>einspringend</translation>
    </message>
    <message>
        <source>transition</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Abrollen</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>exact stop</source>
        <translation>Genauhalt</translation>
    </message>
    <message>
        <source>Sharp: on a transition path the wheel lifts clear of the tip.</source>
        <translation>Spitz: Die Schleifscheibe hebt im Übergang von der Spitze ab.</translation>
    </message>
    <message>
        <source>Sharp, but the wheel cannot lift clear of the tip: it takes the transition path all the same.</source>
        <translation>Spitz, aber die Schleifscheibe kann nicht ganz von der Spitze abheben; der Übergang wird trotzdem gefahren.</translation>
    </message>
    <message>
        <source>Blunt, so not fragile: the wheel rolls round the corner.</source>
        <translation>Stumpf, also nicht bruchgefährdet: Die Schleifscheibe rollt um die Ecke ab.</translation>
    </message>
    <message>
        <source>from the angle</source>
        <translation>aus dem Winkel</translation>
    </message>
    <message>
        <source>limited by the X axis</source>
        <translation>begrenzt durch die X-Achse</translation>
    </message>
    <message>
        <source>limited by the Y axis</source>
        <translation>begrenzt durch die Y-Achse</translation>
    </message>
    <message>
        <source>scaled by the corner speed</source>
        <translation>mit der Eckengeschwindigkeit skaliert</translation>
    </message>
    <message>
        <source>Other glass is in the way of a transition path: the wheel rolls round the corner.</source>
        <translation>Anderes Glas ist einem Übergang im Weg: Die Schleifscheibe rollt um die Ecke ab.</translation>
    </message>
    <message>
        <source>Concave, but shallow: an arc takes the place of the path&apos;s kink.</source>
        <translation>Einspringend, aber flach: Ein Bogen ersetzt den Knick der Bahn.</translation>
    </message>
    <message>
        <source>Concave: the wheel stops where it touches both edges.</source>
        <translation>Einspringend: Die Schleifscheibe hält an, wo sie beide Kanten berührt.</translation>
    </message>
</context>
<context>
    <name>Fault</name>
    <message>
        <source>The emergency stop has tripped.</source>
        <translation>Der Not-Halt hat ausgelöst.</translation>
    </message>
    <message>
        <source>Somebody pressed it, or its circuit is open.</source>
        <translation>Der Not-Halt wurde gedrückt oder sein Stromkreis ist offen.</translation>
    </message>
    <message>
        <source>Make the machine safe, release the button, acknowledge.</source>
        <translation>Maschine sichern, Not-Halt-Taster entriegeln, quittieren.</translation>
    </message>
    <message>
        <source>The encoder of {axis} gives no signal.</source>
        <translation>{axis}: Der Geber liefert kein Signal.</translation>
    </message>
    <message>
        <source>A cable is broken or loose, or the encoder is dirty.</source>
        <translation>Ein Kabel ist gebrochen oder lose, oder der Geber ist verschmutzt.</translation>
    </message>
    <message>
        <source>The axes report nothing any more.</source>
        <translation>Die Achsen melden nichts mehr.</translation>
    </message>
    <message>
        <source>The connection to the drives is broken.</source>
        <translation>Die Verbindung zu den Antrieben ist unterbrochen.</translation>
    </message>
    <message>
        <source>A set-point of {axis} was no number, or jumped by {value} mm/s² more than the axis can follow.</source>
        <translation>{axis}: Ein Sollwert war keine Zahl oder sprang um {value} mm/s² mehr, als die Achse folgen kann.</translation>
    </message>
    <message>
        <source>A fault in Arris.</source>
        <translation>Ein Fehler in Arris.</translation>
    </message>
    <message>
        <source>Save a support bundle and report it. Acknowledge to go on.</source>
        <translation>Supportpaket speichern und Fehler melden. Zum Weiterarbeiten quittieren.</translation>
    </message>
    <message>
        <source>{axis} stands {value} mm away from its set-point.</source>
        <translation>{axis}: Die Achse steht {value} mm neben ihrem Sollwert.</translation>
    </message>
    <message>
        <source>The axis is blocked, or its drive is too weak.</source>
        <translation>Die Achse ist blockiert oder ihr Antrieb ist zu schwach.</translation>
    </message>
    <message>
        <source>Free the axis, check the drive, acknowledge.</source>
        <translation>Achse freimachen, Antrieb prüfen, quittieren.</translation>
    </message>
    <message>
        <source>The drive of {axis} reports a fault.</source>
        <translation>{axis}: Der Antrieb meldet eine Störung.</translation>
    </message>
    <message>
        <source>Overload, overheating, or a fault in the supply.</source>
        <translation>Überlast, Übertemperatur oder Störung der Versorgung.</translation>
    </message>
    <message>
        <source>The drive of {axis} is not ready.</source>
        <translation>{axis}: Der Antrieb ist nicht bereit.</translation>
    </message>
    <message>
        <source>Its supply is off, or a safety circuit is open.</source>
        <translation>Die Versorgung ist aus oder ein Sicherheitskreis ist offen.</translation>
    </message>
    <message>
        <source>{axis} has hit a limit switch.</source>
        <translation>{axis}: Ein Endschalter wurde angefahren.</translation>
    </message>
    <message>
        <source>The axis ran past the end of its travel.</source>
        <translation>Die Achse ist über das Ende ihres Verfahrbereichs gefahren.</translation>
    </message>
    <message>
        <source>Acknowledge, jog the axis back, home again.</source>
        <translation>Quittieren, Achse im Tippbetrieb zurückfahren, neu referenzieren.</translation>
    </message>
    <message>
        <source>{axis} would leave its travel.</source>
        <translation>{axis}: Die Achse würde ihren Verfahrbereich verlassen.</translation>
    </message>
    <message>
        <source>The origin was moved, or the pattern lies too far out.</source>
        <translation>Der Nullpunkt wurde verschoben oder das Muster liegt zu weit außen.</translation>
    </message>
    <message>
        <source>Acknowledge, set the origin, load the job again.</source>
        <translation>Quittieren, Nullpunkt setzen, Auftrag neu laden.</translation>
    </message>
    <message>
        <source>{axis} has not found its reference switch.</source>
        <translation>{axis}: Der Referenzschalter wurde nicht gefunden.</translation>
    </message>
    <message>
        <source>The switch is broken, or the axis did not move.</source>
        <translation>Der Schalter ist defekt oder die Achse hat sich nicht bewegt.</translation>
    </message>
    <message>
        <source>Check the switch and the axis, acknowledge, home again.</source>
        <translation>Schalter und Achse prüfen, quittieren, neu referenzieren.</translation>
    </message>
    <message>
        <source>The rotary buffers ran dry; the wheel was stopped on its path.</source>
        <translation>Die Ringpuffer sind leergelaufen; die Schleifscheibe wurde auf ihrer Bahn angehalten.</translation>
    </message>
    <message>
        <source>The computer was too busy to supply the controller.</source>
        <translation>Der Rechner war zu ausgelastet, um die Steuerung zu versorgen.</translation>
    </message>
    <message>
        <source>Close other programs, acknowledge, resume the job.</source>
        <translation>Andere Programme schließen, quittieren, Auftrag fortsetzen.</translation>
    </message>
    <message>
        <source>The axes report late, by {value} ms.</source>
        <translation>Die Achsen melden um {value} ms zu spät.</translation>
    </message>
    <message>
        <source>The computer or the connection to the drives is overloaded.</source>
        <translation>Der Rechner oder die Verbindung zu den Antrieben ist überlastet.</translation>
    </message>
    <message>
        <source>The axes had no set-point for {value} periods.</source>
        <translation>Die Achsen hatten {value} Takte lang keinen Sollwert.</translation>
    </message>
    <message>
        <source>The computer was too busy to supply them in time.</source>
        <translation>Der Rechner war zu ausgelastet, um sie rechtzeitig zu versorgen.</translation>
    </message>
    <message>
        <source>The operator&apos;s side has not answered for half a second.</source>
        <translation>Die Bedienseite antwortet seit einer halben Sekunde nicht.</translation>
    </message>
    <message>
        <source>The program hangs or has ended.</source>
        <translation>Das Programm hängt oder wurde beendet.</translation>
    </message>
    <message>
        <source>Start Arris again, resume the job.</source>
        <translation>Arris neu starten, Auftrag fortsetzen.</translation>
    </message>
    <message>
        <source>The spindle has lost its speed on the glass.</source>
        <translation>Die Spindel hat auf dem Glas ihre Drehzahl verloren.</translation>
    </message>
    <message>
        <source>The wheel is overloaded or blocked, or the spindle&apos;s drive has a fault.</source>
        <translation>Die Schleifscheibe ist überlastet oder blockiert, oder der Spindelantrieb ist gestört.</translation>
    </message>
    <message>
        <source>Check wheel and spindle, acknowledge, resume the job.</source>
        <translation>Schleifscheibe und Spindel prüfen, quittieren, Auftrag fortsetzen.</translation>
    </message>
    <message>
        <source>The coolant has stopped flowing on the glass.</source>
        <translation>Das Kühlmittel ist auf dem Glas ausgefallen.</translation>
    </message>
    <message>
        <source>The tank is empty, or the pump or a filter is blocked.</source>
        <translation>Der Tank ist leer, oder die Pumpe oder ein Filter ist verstopft.</translation>
    </message>
    <message>
        <source>The vacuum does not hold the glass.</source>
        <translation>Das Vakuum hält das Glas nicht.</translation>
    </message>
    <message>
        <source>A cup leaks, or the pump is off.</source>
        <translation>Ein Sauger ist undicht oder die Pumpe ist aus.</translation>
    </message>
    <message>
        <source>Check cups and pump, place the glass again, acknowledge.</source>
        <translation>Sauger und Pumpe prüfen, Glas neu auflegen, quittieren.</translation>
    </message>
    <message>
        <source>The spindle does not reach its speed.</source>
        <translation>Die Spindel erreicht ihre Drehzahl nicht.</translation>
    </message>
    <message>
        <source>The spindle&apos;s drive is off or has a fault.</source>
        <translation>Der Spindelantrieb ist aus oder gestört.</translation>
    </message>
    <message>
        <source>Check the spindle, acknowledge, start again.</source>
        <translation>Spindel prüfen, quittieren, neu starten.</translation>
    </message>
    <message>
        <source>The coolant does not flow.</source>
        <translation>Das Kühlmittel fließt nicht.</translation>
    </message>
    <message>
        <source>The tank is empty, a valve is closed, or the pump is off.</source>
        <translation>Der Tank ist leer, ein Ventil ist geschlossen oder die Pumpe ist aus.</translation>
    </message>
    <message>
        <source>Check the coolant, acknowledge, start again.</source>
        <translation>Kühlmittel prüfen, quittieren, neu starten.</translation>
    </message>
    <message>
        <source>an axis</source>
        <translation>Eine Achse</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 mm/s²</source>
        <translation>%1 mm/s²</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 periods</source>
        <translation>%1 Takte</translation>
    </message>
    <message>
        <source>Repair the encoder or its cable, acknowledge, home again.</source>
        <translation>Geber oder Kabel instand setzen, quittieren, neu referenzieren.</translation>
    </message>
    <message>
        <source>Restore the connection, acknowledge, home again.</source>
        <translation>Verbindung wiederherstellen, quittieren, neu referenzieren.</translation>
    </message>
    <message>
        <source>Read the drive&apos;s display, clear its fault, acknowledge.</source>
        <translation>Anzeige am Antrieb ablesen, Störung beheben, quittieren.</translation>
    </message>
    <message>
        <source>Switch its supply on, close the safety circuit, acknowledge.</source>
        <translation>Versorgung einschalten, Sicherheitskreis schließen, quittieren.</translation>
    </message>
    <message>
        <source>Restore the coolant, acknowledge, resume the job.</source>
        <translation>Kühlmittel wiederherstellen, quittieren, Auftrag fortsetzen.</translation>
    </message>
</context>
<context>
    <name>JobSheet</name>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>X %1, Y %2 mm</source>
        <translation>X %1, Y %2 mm</translation>
    </message>
    <message>
        <source>chosen by the program</source>
        <translation>vom Programm gewählt</translation>
    </message>
    <message>
        <source>Job sheet: %1</source>
        <translation>Auftragsblatt: %1</translation>
    </message>
    <message>
        <source>X reversed</source>
        <translation>X umgekehrt</translation>
    </message>
    <message>
        <source>Y reversed</source>
        <translation>Y umgekehrt</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>Accelerations bind</source>
        <translation>Beschleunigungen gelten</translation>
    </message>
    <message>
        <source>each axis on its own</source>
        <translation>für jede Achse einzeln</translation>
    </message>
    <message>
        <source>X and Y together</source>
        <translation>für X und Y gemeinsam</translation>
    </message>
    <message>
        <source>Direction round outlines</source>
        <translation>Umlaufsinn an Außenkonturen</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>counter-clockwise</source>
        <translation>gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Gespiegelt</translation>
    </message>
    <message>
        <source>Unit of the drawing</source>
        <translation>Einheit der Zeichnung</translation>
    </message>
    <message>
        <source>as its file says</source>
        <translation>wie in der Datei</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Layer</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>What the wheel cannot reach may stay unground</source>
        <translation>Unerreichbares darf ungeschliffen bleiben</translation>
    </message>
    <message>
        <source>Start nearest to</source>
        <translation>Start möglichst nahe bei</translation>
    </message>
    <message>
        <source>Lower left of the pane</source>
        <translation>Glasscheibe links unten</translation>
    </message>
    <message>
        <source>Travel</source>
        <translation>Verfahrbereich</translation>
    </message>
    <message>
        <source>Greatest speed</source>
        <translation>Höchstgeschwindigkeit</translation>
    </message>
    <message>
        <source>Greatest acceleration</source>
        <translation>Höchstbeschleunigung</translation>
    </message>
    <message>
        <source>Park position</source>
        <translation>Parkposition</translation>
    </message>
    <message>
        <source>Feed when going down</source>
        <translation>Vorschub beim Absenken</translation>
    </message>
    <message>
        <source>Period of the axes</source>
        <translation>Takt der Achsen</translation>
    </message>
    <message>
        <source>Back-off from the glass</source>
        <translation>Rückzug vom Glas</translation>
    </message>
    <message>
        <source>%1 mm after %2 s</source>
        <translation>%1 mm nach %2 s</translation>
    </message>
    <message>
        <source>Following error allowed</source>
        <translation>Zulässiger Schleppabstand</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>Angle β</source>
        <translation>Winkel β</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Treatment</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Speed v, mm/s</source>
        <translation>Geschw. v, mm/s</translation>
    </message>
    <message>
        <source>Time t, s</source>
        <translation>Zeit t, s</translation>
    </message>
    <message>
        <source>Relief margin, mm</source>
        <translation>Freigangreserve, mm</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>None.</source>
        <translation>Keine.</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Zeiten</translation>
    </message>
    <message>
        <source>The pattern cannot be ground.</source>
        <translation>Das Muster ist nicht schleifbar.</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>Grinding, lead-in to lead-out</source>
        <translation>Schleifen, mit An- und Abfahrweg</translation>
    </message>
    <message>
        <source>Whole program</source>
        <translation>Ganzes Programm</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Rezept</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Repairs of the drawing</source>
        <translation>Reparaturen der Zeichnung</translation>
    </message>
    <message>
        <source>%1, continued</source>
        <translation>%1, Fortsetzung</translation>
    </message>
</context>
<context>
    <name>JobState</name>
    <message>
        <source>Idle</source>
        <translation>Untätig</translation>
    </message>
    <message>
        <source>Queued</source>
        <translation>Eingereiht</translation>
    </message>
    <message>
        <source>Released</source>
        <translation>Freigegeben</translation>
    </message>
    <message>
        <source>Initialized</source>
        <translation>Geladen</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Unterbrochen</translation>
    </message>
    <message>
        <source>Aborted</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Beendet</translation>
    </message>
</context>
<context>
    <name>Legend</name>
    <message>
        <source>Finished contour</source>
        <translation>Fertigkontur</translation>
    </message>
    <message>
        <source>Not in a contour</source>
        <translation>In keiner Kontur</translation>
    </message>
    <message>
        <source>Wheel path</source>
        <translation>Schleifbahn</translation>
    </message>
    <message>
        <source>Corner transition</source>
        <translation>Eckenübergang</translation>
    </message>
    <message>
        <source>Lead-in, lead-out</source>
        <translation>An- und Abfahrweg</translation>
    </message>
    <message>
        <source>Rapid above the glass</source>
        <translation>Eilgang über dem Glas</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Wheel down, up</source>
        <translation>Schleifscheibe ab, auf</translation>
    </message>
    <message>
        <source>Travel of the machine</source>
        <translation>Verfahrbereich</translation>
    </message>
    <message>
        <source>Slower between these</source>
        <translation>Dazwischen langsamer</translation>
    </message>
    <message>
        <source>Roll or arc at a corner</source>
        <translation>Abrollen, Bogen an Ecke</translation>
    </message>
    <message>
        <source>Stop in a concave corner</source>
        <translation>Halt in einspringender Ecke</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Note, repair</source>
        <translation>Hinweis, Reparatur</translation>
    </message>
</context>
<context>
    <name>Machine</name>
    <message>
        <source>Feed of plunges</source>
        <translation>Vorschub beim Absenken</translation>
    </message>
    <message>
        <source>Servo period</source>
        <translation>Servotakt</translation>
    </message>
    <message>
        <source>Homing: speed towards the switch</source>
        <translation>Referenzfahrt: Geschwindigkeit zum Schalter</translation>
    </message>
    <message>
        <source>Homing: speed off the switch</source>
        <translation>Referenzfahrt: Geschwindigkeit vom Schalter weg</translation>
    </message>
    <message>
        <source>Fastest jog</source>
        <translation>Höchste Tippgeschwindigkeit</translation>
    </message>
    <message>
        <source>Set-points ahead of time</source>
        <translation>Vorlauf der Sollwerte</translation>
    </message>
    <message>
        <source>Greatest following error</source>
        <translation>Größter Schleppabstand</translation>
    </message>
    <message>
        <source>Backing off in a hold</source>
        <translation>Rückzug bei Halt</translation>
    </message>
    <message>
        <source>At rest before backing off</source>
        <translation>Stillstand vor dem Rückzug</translation>
    </message>
    <message>
        <source>Longest wait for spindle and coolant</source>
        <translation>Längste Wartezeit auf Spindel und Kühlmittel</translation>
    </message>
    <message>
        <source>Travel of the axes</source>
        <translation>Verfahrbereich der Achsen</translation>
    </message>
    <message>
        <source>Greatest speeds of the axes</source>
        <translation>Höchstgeschwindigkeiten der Achsen</translation>
    </message>
    <message>
        <source>Greatest accelerations of the axes</source>
        <translation>Höchstbeschleunigungen der Achsen</translation>
    </message>
    <message>
        <source>Park position</source>
        <translation>Parkposition</translation>
    </message>
    <message>
        <source>Reference switches</source>
        <translation>Referenzschalter</translation>
    </message>
    <message>
        <source>Jog only while the panel&apos;s jog enable is held</source>
        <translation>Tippen nur bei gehaltener Tippfreigabe am Bedienpult</translation>
    </message>
</context>
<context>
    <name>Phase</name>
    <message>
        <source>Approach</source>
        <translation>Positionieren</translation>
    </message>
    <message>
        <source>Plunge</source>
        <translation>Absenken</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Anfahrweg</translation>
    </message>
    <message>
        <source>Cruise</source>
        <translation>Konstantfahrt</translation>
    </message>
    <message>
        <source>Decelerate</source>
        <translation>Abbremsen</translation>
    </message>
    <message>
        <source>Transition</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Abrollen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Halt</translation>
    </message>
    <message>
        <source>Accelerate</source>
        <translation>Beschleunigen</translation>
    </message>
    <message>
        <source>Lead-out</source>
        <translation>Abfahrweg</translation>
    </message>
    <message>
        <source>Retract</source>
        <translation>Abheben</translation>
    </message>
    <message>
        <source>Traverse</source>
        <translation>Umsetzen</translation>
    </message>
</context>
<context>
    <name>PreviewPage</name>
    <message>
        <source>on the table</source>
        <translation>auf dem Tisch</translation>
    </message>
    <message>
        <source>of the drawing</source>
        <translation>der Zeichnung</translation>
    </message>
    <message>
        <source>X %1, mm</source>
        <translation>X %1, mm</translation>
    </message>
    <message>
        <source>Y %1, mm</source>
        <translation>Y %1, mm</translation>
    </message>
    <message>
        <source>Scale 1 : %1</source>
        <translation>Maßstab 1 : %1</translation>
    </message>
    <message>
        <source>No contour</source>
        <translation>Keine Kontur</translation>
    </message>
    <message>
        <source>Pane %1, lower left at X %2, Y %3</source>
        <translation>Glasscheibe %1, links unten bei X %2, Y %3</translation>
    </message>
    <message>
        <source>glass %1 mm</source>
        <translation>Glasdicke %1 mm</translation>
    </message>
    <message>
        <source>corners: %1</source>
        <translation>Ecken: %1</translation>
    </message>
    <message>
        <source>Wheel R %1 mm · depth %2 mm · feed %3 mm/min · acceleration X %4, Y %5 mm/s²</source>
        <translation>Schleifscheibe R %1 mm · Tiefe %2 mm · Vorschub %3 mm/min · Beschleunigung X %4, Y %5 mm/s²</translation>
    </message>
    <message>
        <source>Cannot be ground</source>
        <translation>Nicht schleifbar</translation>
    </message>
    <message>
        <source>Grinding %1 · whole program %2 · wheel path %3 mm</source>
        <translation>Schleifen %1 · ganzes Programm %2 · Schleifbahn %3 mm</translation>
    </message>
    <message>
        <source>pieces in no contour: %1</source>
        <translation>Stücke in keiner Kontur: %1</translation>
    </message>
    <message>
        <source>… and %1 more kinds of findings</source>
        <translation>… und %1 weitere Arten von Befunden</translation>
    </message>
    <message>
        <source>Contours: %1 (outlines %2, cut-outs %3)</source>
        <translation>Konturen: %1 (Außenkonturen %2, Ausschnitte %3)</translation>
    </message>
    <message>
        <source>And %1 more like it.</source>
        <translation>Und %1 weitere dieser Art.</translation>
    </message>
    <message>
        <source>Contours: %1</source>
        <translation>Konturen: %1</translation>
    </message>
</context>
<context>
    <name>Problem</name>
    <message>
        <source>{file} cannot be opened: {reason}.</source>
        <translation>{file} kann nicht geöffnet werden: {reason}.</translation>
    </message>
    <message>
        <source>{file} cannot be read: {reason}.</source>
        <translation>{file} kann nicht gelesen werden: {reason}.</translation>
    </message>
    <message>
        <source>{file} cannot be written: {reason}.</source>
        <translation>{file} kann nicht geschrieben werden: {reason}.</translation>
    </message>
    <message>
        <source>{file} is not valid JSON: {reason}.</source>
        <translation>{file} ist kein gültiges JSON: {reason}.</translation>
    </message>
    <message>
        <source>{file} has no &quot;{key}&quot;: it is not such a file.</source>
        <translation>{file} hat kein „{key}“: Es ist keine solche Datei.</translation>
    </message>
    <message>
        <source>{file} was written by a newer Arris (&quot;{key}&quot;: {version}); this one reads up to {known}.</source>
        <translation>{file} wurde von einem neueren Arris geschrieben („{key}“: {version}); dieses liest bis {known}.</translation>
    </message>
    <message>
        <source>{file} has a key &quot;{key}&quot; that Arris does not know; it is ignored.</source>
        <translation>{file} hat einen Schlüssel „{key}“, den Arris nicht kennt; er wird nicht beachtet.</translation>
    </message>
    <message>
        <source>{name} must be {expected}, not {value}.</source>
        <translation>{name} muss {expected} sein, nicht {value}.</translation>
    </message>
    <message>
        <source>{name} must be a number in {unit}, not &quot;{value}&quot;.</source>
        <translation>{name} muss eine Zahl in {unit} sein, nicht „{value}“.</translation>
    </message>
    <message>
        <source>{name} is {value} {unit}; it must be from {least} to {most} {unit}.</source>
        <translation>{name} ist {value} {unit}; erlaubt sind {least} bis {most} {unit}.</translation>
    </message>
    <message>
        <source>{name} is {value} {unit}; the machine allows {most} {unit} at most.</source>
        <translation>{name} ist {value} {unit}; die Maschine erlaubt höchstens {most} {unit}.</translation>
    </message>
    <message>
        <source>{name} is &quot;{value}&quot;; it must be one of: {choices}.</source>
        <translation>{name} ist „{value}“; möglich sind: {choices}.</translation>
    </message>
    <message>
        <source>{file} is not a profile of Arris: {reason}.</source>
        <translation>{file} ist kein Profil von Arris: {reason}.</translation>
    </message>
    <message>
        <source>The pattern file is empty.</source>
        <translation>Die Musterdatei ist leer.</translation>
    </message>
    <message>
        <source>This is not a DXF file: {reason}.</source>
        <translation>Das ist keine DXF-Datei: {reason}.</translation>
    </message>
    <message>
        <source>The lines end in carriage returns alone; save the file with LF or CR LF.</source>
        <translation>Die Zeilen enden nur mit Wagenrücklauf (CR); bitte die Datei mit LF oder CR LF speichern.</translation>
    </message>
    <message>
        <source>A group code is expected here, not {found}.</source>
        <translation>Hier muss ein Gruppencode stehen, nicht {found}.</translation>
    </message>
    <message>
        <source>Group {group} must hold a finite number, not {found}.</source>
        <translation>Gruppe {group} muss eine endliche Zahl enthalten, nicht {found}.</translation>
    </message>
    <message>
        <source>Group {group} holds {found}, which is absurd for a pane of glass (more than {most}).</source>
        <translation>Gruppe {group} enthält {found}; für eine Glasscheibe ist das unsinnig (mehr als {most}).</translation>
    </message>
    <message>
        <source>The file ends early: {reason}. It was cut off.</source>
        <translation>Die Datei endet zu früh: {reason}. Sie wurde abgeschnitten.</translation>
    </message>
    <message>
        <source>The sections of the file are broken: {reason}.</source>
        <translation>Die Abschnitte der Datei sind fehlerhaft: {reason}.</translation>
    </message>
    <message>
        <source>{entity} announces {announced} {what} but has {found}.</source>
        <translation>{entity} kündigt {announced} {what} an, hat aber {found}.</translation>
    </message>
    <message>
        <source>{entity} lacks group {group} ({what}).</source>
        <translation>{entity}: Gruppe {group} fehlt ({what}).</translation>
    </message>
    <message>
        <source>{entity} has {what} {value}, which cannot be.</source>
        <translation>{entity} hat {what} {value}; das kann nicht sein.</translation>
    </message>
    <message>
        <source>The file does not say its unit; millimetres are assumed.</source>
        <translation>Die Datei nennt ihre Einheit nicht; Millimeter werden angenommen.</translation>
    </message>
    <message>
        <source>The file gives its unit as number {number}, which is not mm, cm, m, inch or foot; say the unit with --units.</source>
        <translation>Die Datei gibt ihre Einheit als Nummer {number} an; das ist weder mm, cm, m, Zoll noch Fuß. Die Einheit bitte mit --units angeben.</translation>
    </message>
    <message>
        <source>{count} × {entity} not read yet; the contour would lack it.</source>
        <translation>{count} × {entity} kann noch nicht gelesen werden; es würde der Kontur fehlen.</translation>
    </message>
    <message>
        <source>{count} × {entity} not flat in a plane parallel to the XY plane.</source>
        <translation>{count} × {entity} liegt nicht flach in einer Ebene parallel zur XY-Ebene.</translation>
    </message>
    <message>
        <source>{count} × {entity} passed over: {reason}.</source>
        <translation>{count} × {entity} übergangen: {reason}.</translation>
    </message>
    <message>
        <source>{count} more of {code} are not listed.</source>
        <translation>{count} weitere von {code} sind nicht aufgeführt.</translation>
    </message>
    <message>
        <source>A doubled piece of {size_mm} mm was removed.</source>
        <translation>Ein doppeltes Stück von {size_mm} mm wurde entfernt.</translation>
    </message>
    <message>
        <source>A piece without length ({size_mm} mm) was removed.</source>
        <translation>Ein Stück ohne Länge ({size_mm} mm) wurde entfernt.</translation>
    </message>
    <message>
        <source>A gap of {size_mm} mm was closed.</source>
        <translation>Eine Lücke von {size_mm} mm wurde geschlossen.</translation>
    </message>
    <message>
        <source>The contour is open here: the next free end is {gap_mm} mm away (up to {tolerance_mm} mm are joined).</source>
        <translation>Die Kontur ist hier offen: Das nächste freie Ende ist {gap_mm} mm entfernt (bis {tolerance_mm} mm wird verbunden).</translation>
    </message>
    <message>
        <source>{count} pieces meet here; a contour cannot branch.</source>
        <translation>Hier treffen sich {count} Stücke; eine Kontur darf sich nicht verzweigen.</translation>
    </message>
    <message>
        <source>The drawing has no closed contour.</source>
        <translation>Die Zeichnung hat keine geschlossene Kontur.</translation>
    </message>
    <message>
        <source>The contour encloses no area.</source>
        <translation>Die Kontur umschließt keine Fläche.</translation>
    </message>
    <message>
        <source>The contour crosses or touches itself here.</source>
        <translation>Die Kontur kreuzt oder berührt sich hier selbst.</translation>
    </message>
    <message>
        <source>The contour turns back on itself here, in a tip of {angle_deg}°; that is a mistake of the drawing.</source>
        <translation>Die Kontur kehrt hier in einer Spitze von {angle_deg}° um; das ist ein Fehler der Zeichnung.</translation>
    </message>
    <message>
        <source>Corner {corner}: the wheel lifts by {lift_mm} mm, less than the {depth_mm} mm of glass at the tip.</source>
        <translation>Ecke {corner}: Die Schleifscheibe hebt sich um {lift_mm} mm ab, weniger als die {depth_mm} mm Glas an der Spitze.</translation>
    </message>
    <message>
        <source>Corner {corner} takes {time_s} s.</source>
        <translation>Ecke {corner} dauert {time_s} s.</translation>
    </message>
    <message>
        <source>The overlap is {used_mm} mm, a quarter of the contour, instead of {wanted_mm} mm.</source>
        <translation>Die Überlappung beträgt {used_mm} mm, ein Viertel der Kontur, statt {wanted_mm} mm.</translation>
    </message>
    <message>
        <source>The wheel path leaves the travel of the machine by {excess_mm} mm: {what}.</source>
        <translation>Die Schleifbahn verlässt den Verfahrbereich der Maschine um {excess_mm} mm: {what}.</translation>
    </message>
    <message>
        <source>The wheel&apos;s lower face would be {height_mm} mm above the table while grinding; it must stay {least_mm} mm above.</source>
        <translation>Die Unterseite der Schleifscheibe wäre beim Schleifen {height_mm} mm über dem Tisch; es müssen mindestens {least_mm} mm sein.</translation>
    </message>
    <message>
        <source>The {what} height of {height_mm} mm is outside the travel of 0 to {most_mm} mm.</source>
        <translation>Die {what} von {height_mm} mm liegt außerhalb des Verfahrbereichs von 0 bis {most_mm} mm.</translation>
    </message>
    <message>
        <source>The grinding height of {height_mm} mm is above the clearance height of {clearance_mm} mm.</source>
        <translation>Die Schleifhöhe von {height_mm} mm liegt über der Sicherheitshöhe von {clearance_mm} mm.</translation>
    </message>
    <message>
        <source>The machine&apos;s greatest speed of the {axis} axis is below the feed; it limits the speed on the contour.</source>
        <translation>Die Höchstgeschwindigkeit der {axis}-Achse ist kleiner als der Vorschub; sie begrenzt die Geschwindigkeit auf der Kontur.</translation>
    </message>
    <message>
        <source>Internal error: {reason}.</source>
        <translation>Interner Fehler: {reason}.</translation>
    </message>
    <message>
        <source>Axes through LinuxCNC are not available: {reason}.</source>
        <translation>Achsen über LinuxCNC sind nicht verfügbar: {reason}.</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>A single piece, its ends {length_mm} mm apart, belongs to no contour; it may lie on top of another.</source>
        <translation>Ein einzelnes Stück, dessen Enden {length_mm} mm auseinanderliegen, gehört zu keiner Kontur; vielleicht liegt es auf einem anderen.</translation>
    </message>
    <message>
        <source>The wheel cannot {what} here: it needs {needed_mm} mm between its centre and the glass and has {distance_mm} mm. Start on a longer edge away from sharp corners, or change the lead&apos;s radius.</source>
        <translation>Die Scheibe kann hier nicht {what}: sie braucht {needed_mm} mm zwischen ihrer Mitte und dem Glas und hat {distance_mm} mm. Auf einer längeren Kante abseits scharfer Ecken anfangen oder den Radius der Anfahrwege ändern.</translation>
    </message>
    <message>
        <source>At the park position the wheel&apos;s lower face would be {height_mm} mm above the table, over or beside the glass; it must be {least_mm} mm above.</source>
        <translation>In der Parkposition wäre die Unterseite der Scheibe {height_mm} mm über dem Tisch, über dem Glas oder neben ihm; es müssen {least_mm} mm sein.</translation>
    </message>
    <message>
        <source>The binary DXF file is damaged: {reason}.</source>
        <translation>Die binäre DXF-Datei ist beschädigt: {reason}.</translation>
    </message>
    <message>
        <source>Block {block} is defined twice, first on line {first}; give one of them another name.</source>
        <translation>Block {block} ist zweimal definiert, zuerst in Zeile {first}; einem davon einen anderen Namen geben.</translation>
    </message>
    <message>
        <source>{count} × INSERT of block {entity}, which the file does not have; explode it before saving.</source>
        <translation>{count} × INSERT von Block {entity}, den die Datei nicht enthält; vor dem Speichern auflösen.</translation>
    </message>
    <message>
        <source>Block {block} inserts itself here, or blocks are nested more than {most} deep; explode it before saving.</source>
        <translation>Block {block} fügt hier sich selbst ein, oder Blöcke sind mehr als {most}-fach verschachtelt; vor dem Speichern auflösen.</translation>
    </message>
    <message>
        <source>INSERT of block {entity} would make more than {most} pieces of the drawing; draw fewer copies.</source>
        <translation>INSERT von Block {entity} würde mehr als {most} Stücke ergeben; weniger Kopien zeichnen.</translation>
    </message>
    <message>
        <source>The SPLINE is no curve: {reason}.</source>
        <translation>Die SPLINE ist keine Kurve: {reason}.</translation>
    </message>
    <message>
        <source>From here on the curves of the drawing are too long or too many to follow with arcs ({most} steps).</source>
        <translation>Ab hier sind die Kurven der Zeichnung zu lang oder zu viele, um ihnen mit Bögen zu folgen ({most} Schritte).</translation>
    </message>
    <message>
        <source>{entity} lies {distance_mm} mm away, which is absurd for a pane of glass (more than {most_mm} mm).</source>
        <translation>{entity} liegt {distance_mm} mm entfernt, was für eine Glasscheibe unsinnig ist (mehr als {most_mm} mm).</translation>
    </message>
    <message>
        <source>A piece ends here on another one, between that one&apos;s ends; a contour cannot branch. Remove one of them.</source>
        <translation>Ein Stück endet hier auf einem anderen, zwischen dessen Enden; eine Kontur kann sich nicht verzweigen. Eines davon entfernen.</translation>
    </message>
    <message>
        <source>Contours {first} and {second} cross or touch here; move them apart in the drawing.</source>
        <translation>Die Konturen {first} und {second} kreuzen oder berühren sich hier; in der Zeichnung auseinanderrücken.</translation>
    </message>
    <message>
        <source>The {count} joints from here on look like the chords of a curve but stay corners: they are joined from a smoothing tolerance of {needed_mm} mm on (now {tolerance_mm} mm).</source>
        <translation>Die {count} Stöße ab hier sehen aus wie die Sehnen einer Kurve, bleiben aber Ecken: Sie werden ab einer Glättungstoleranz von {needed_mm} mm verbunden (jetzt {tolerance_mm} mm).</translation>
    </message>
    <message>
        <source>The wheel of {wheel_mm} mm radius does not reach {length_mm} mm of the contour here; up to {left_mm} mm of glass would stay. Take a wheel of at most {largest_mm} mm, or accept that this stays unground.</source>
        <translation>Die Schleifscheibe mit {wheel_mm} mm Radius erreicht hier {length_mm} mm der Kontur nicht; bis zu {left_mm} mm Glas blieben stehen. Eine Schleifscheibe von höchstens {largest_mm} mm nehmen oder zulassen, dass dies ungeschliffen bleibt.</translation>
    </message>
    <message>
        <source>The wheel of {wheel_mm} mm radius does not reach {length_mm} mm of the contour here; up to {left_mm} mm of glass stay. A wheel of at most {largest_mm} mm would.</source>
        <translation>Die Schleifscheibe mit {wheel_mm} mm Radius erreicht hier {length_mm} mm der Kontur nicht; bis zu {left_mm} mm Glas bleiben stehen. Eine Schleifscheibe von höchstens {largest_mm} mm würde es.</translation>
    </message>
    <message>
        <source>The wheel of {wheel_mm} mm radius does not reach this contour of {length_mm} mm at all. Take a wheel of less than {largest_mm} mm, or accept that it stays unground.</source>
        <translation>Die Schleifscheibe mit {wheel_mm} mm Radius erreicht diese Kontur von {length_mm} mm überhaupt nicht. Eine Schleifscheibe unter {largest_mm} mm nehmen oder zulassen, dass sie ungeschliffen bleibt.</translation>
    </message>
    <message>
        <source>This contour of {length_mm} mm stays unground: the wheel of {wheel_mm} mm radius does not reach it. A wheel of less than {largest_mm} mm would.</source>
        <translation>Diese Kontur von {length_mm} mm bleibt ungeschliffen: Die Schleifscheibe mit {wheel_mm} mm Radius erreicht sie nicht. Eine Schleifscheibe unter {largest_mm} mm würde es.</translation>
    </message>
    <message>
        <source>The wheel of {wheel_mm} mm radius reaches no contour at all.</source>
        <translation>Die Schleifscheibe mit {wheel_mm} mm Radius erreicht überhaupt keine Kontur.</translation>
    </message>
    <message>
        <source>Corner {corner} is concave: the wheel leaves {fillet_mm} mm of glass before it, and {unground_mm} mm of its edges are not ground.</source>
        <translation>Ecke {corner} ist einspringend: Die Schleifscheibe lässt {fillet_mm} mm Glas vor ihr stehen, und {unground_mm} mm ihrer Kanten werden nicht geschliffen.</translation>
    </message>
    <message>
        <source>Corner {corner}: a transition would touch other glass here; the wheel rolls round the corner instead.</source>
        <translation>Ecke {corner}: Ein Übergang würde hier anderes Glas berühren; die Schleifscheibe rollt stattdessen um die Ecke ab.</translation>
    </message>
    <message>
        <source>A size correction of {correction_mm} mm would change the shape of the contour here.</source>
        <translation>Eine Maßkorrektur von {correction_mm} mm würde hier die Form der Kontur ändern.</translation>
    </message>
    <message>
        <source>The wheel cannot {what} here: it needs {needed_mm} mm between its centre and the glass and has {distance_mm} mm. What it would grind from here stays unground.</source>
        <translation>Die Scheibe kann hier nicht {what}: sie braucht {needed_mm} mm zwischen ihrer Mitte und dem Glas und hat {distance_mm} mm. Was sie von hier aus schliffe, bleibt ungeschliffen.</translation>
    </message>
    <message>
        <source>(line %1 of the file, at X %2, Y %3 mm)</source>
        <translation>(Zeile %1 der Datei, bei X %2, Y %3 mm)</translation>
    </message>
    <message>
        <source>(line %1 of the file)</source>
        <translation>(Zeile %1 der Datei)</translation>
    </message>
    <message>
        <source>(at X %1, Y %2 mm)</source>
        <translation>(bei X %1, Y %2 mm)</translation>
    </message>
    <message>
        <source>From here on so many contours lie over or within each other that they cannot be checked (more than {most} comparisons); draw fewer.</source>
        <translation>Ab hier liegen so viele Konturen über- oder ineinander, dass sie nicht geprüft werden können (mehr als {most} Vergleiche); weniger zeichnen.</translation>
    </message>
    <message>
        <source>{file} is not the record of a run: {reason}.</source>
        <translation>{file} ist keine Aufzeichnung eines Laufs: {reason}.</translation>
    </message>
    <message>
        <source>{file} is not whole: {reason} at byte {byte}. What can be read is used.</source>
        <translation>{file} ist nicht vollständig: {reason} (ab Byte {byte}). Was lesbar ist, wird verwendet.</translation>
    </message>
    <message>
        <source>{file} is damaged and was kept as {kept}; hours and metres are counted from zero.</source>
        <translation>{file} ist beschädigt und wurde als {kept} aufgehoben; Stunden und Meter werden ab null gezählt.</translation>
    </message>
    <message>
        <source>{file} is not a back-up that can be restored: {reason}.</source>
        <translation>{file} ist keine Sicherung, die sich einlesen lässt: {reason}.</translation>
    </message>
    <message>
        <source>The job that was broken off is of another pattern or an earlier state of it: {file} had the fingerprint {was}, now it has {is}.</source>
        <translation>Der abgebrochene Auftrag gehört zu einem anderen Muster oder einem früheren Stand davon: {file} hatte den Fingerabdruck {was}, jetzt hat die Datei {is}.</translation>
    </message>
    <message>
        <source>The job that was broken off was planned for another machine: {key} was {was}, now it is {is}.</source>
        <translation>Der abgebrochene Auftrag wurde für eine andere Maschine geplant: {key} war {was}, jetzt ist es {is}.</translation>
    </message>
    <message>
        <source>The place where the job was broken off (segment {segment}, {lambda_mm} mm) is not on the job as it is planned now.</source>
        <translation>Die Stelle, an der der Auftrag abgebrochen wurde (Segment {segment}, {lambda_mm} mm), liegt nicht auf dem Auftrag, wie er jetzt geplant ist.</translation>
    </message>
    <message>
        <source>{file} is damaged and has no effect; it was kept as {aside}.</source>
        <translation>{file} ist beschädigt und hat keine Wirkung; die Datei wurde als {aside} aufgehoben.</translation>
    </message>
    <message>
        <source>It was given up before it was done.</source>
        <translation>Der Vorgang wurde vor dem Ende abgebrochen.</translation>
    </message>
</context>
<context>
    <name>ProblemWord</name>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner nicht gefunden</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Zugriff verweigert</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>Das ist ein Ordner</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Ein-/Ausgabefehler</translation>
    </message>
    <message>
        <source>it holds NUL bytes</source>
        <translation>Sie enthält NUL-Bytes</translation>
    </message>
    <message>
        <source>it is a DWG drawing; save it as DXF</source>
        <translation>Es ist eine DWG-Zeichnung; bitte als DXF speichern</translation>
    </message>
    <message>
        <source>it is UTF-16 text; save it as ASCII DXF</source>
        <translation>Es ist UTF-16-Text; bitte als DXF speichern</translation>
    </message>
    <message>
        <source>it begins with {} and not with a group code</source>
        <translation>Sie beginnt mit {} und nicht mit einem Gruppencode</translation>
    </message>
    <message>
        <source>an empty line</source>
        <translation>eine leere Zeile</translation>
    </message>
    <message>
        <source>the last group code has no value</source>
        <translation>Der letzte Gruppencode hat keinen Wert</translation>
    </message>
    <message>
        <source>there is no EOF</source>
        <translation>EOF fehlt</translation>
    </message>
    <message>
        <source>there is no EOF; the last POLYLINE has no SEQEND</source>
        <translation>EOF fehlt; die letzte POLYLINE hat kein SEQEND</translation>
    </message>
    <message>
        <source>there is no EOF, and section {} has no ENDSEC</source>
        <translation>EOF fehlt, und Abschnitt {} hat kein ENDSEC</translation>
    </message>
    <message>
        <source>section {} has no ENDSEC before the next SECTION</source>
        <translation>Abschnitt {} hat kein ENDSEC vor der nächsten SECTION</translation>
    </message>
    <message>
        <source>section {} has no ENDSEC before EOF</source>
        <translation>Abschnitt {} hat kein ENDSEC vor EOF</translation>
    </message>
    <message>
        <source>ENDSEC without a SECTION</source>
        <translation>ENDSEC ohne SECTION</translation>
    </message>
    <message>
        <source>the section has no name</source>
        <translation>Der Abschnitt hat keinen Namen</translation>
    </message>
    <message>
        <source>the POLYLINE of line {} has no SEQEND</source>
        <translation>Die POLYLINE von Zeile {} hat kein SEQEND</translation>
    </message>
    <message>
        <source>the POLYLINE of line {} has no SEQEND before {}</source>
        <translation>Die POLYLINE von Zeile {} hat kein SEQEND vor {}</translation>
    </message>
    <message>
        <source>{} without a POLYLINE before it</source>
        <translation>{} ohne POLYLINE davor</translation>
    </message>
    <message>
        <source>group {} belongs to no entity</source>
        <translation>Gruppe {} gehört zu keinem Element</translation>
    </message>
    <message>
        <source>group {} stands outside of any section</source>
        <translation>Gruppe {} steht außerhalb der Abschnitte</translation>
    </message>
    <message>
        <source>{} stands outside of any section</source>
        <translation>{} steht außerhalb der Abschnitte</translation>
    </message>
    <message>
        <source>group {}</source>
        <translation>die Gruppe {}</translation>
    </message>
    <message>
        <source>twice</source>
        <translation>doppelt</translation>
    </message>
    <message>
        <source>X of its start</source>
        <translation>X des Anfangs</translation>
    </message>
    <message>
        <source>Y of its start</source>
        <translation>Y des Anfangs</translation>
    </message>
    <message>
        <source>X of its end</source>
        <translation>X des Endes</translation>
    </message>
    <message>
        <source>Y of its end</source>
        <translation>Y des Endes</translation>
    </message>
    <message>
        <source>X of its centre</source>
        <translation>X des Mittelpunkts</translation>
    </message>
    <message>
        <source>Y of its centre</source>
        <translation>Y des Mittelpunkts</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>start angle</source>
        <translation>Startwinkel</translation>
    </message>
    <message>
        <source>end angle</source>
        <translation>Endwinkel</translation>
    </message>
    <message>
        <source>the radius</source>
        <translation>den Radius</translation>
    </message>
    <message>
        <source>a bulge of</source>
        <translation>eine Wölbung (bulge) von</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>Scheitelpunkte</translation>
    </message>
    <message>
        <source>on layer {}, which is never plotted</source>
        <translation>auf Layer {}, der nie geplottet wird</translation>
    </message>
    <message>
        <source>layer {} is frozen</source>
        <translation>Layer {} ist gefroren</translation>
    </message>
    <message>
        <source>layer {} is off</source>
        <translation>Layer {} ist ausgeschaltet</translation>
    </message>
    <message>
        <source>in paper space</source>
        <translation>im Papierbereich</translation>
    </message>
    <message>
        <source>no part of a contour</source>
        <translation>kein Teil einer Kontur</translation>
    </message>
    <message>
        <source>invisible</source>
        <translation>unsichtbar</translation>
    </message>
    <message>
        <source>go down</source>
        <translation>abgesenkt werden</translation>
    </message>
    <message>
        <source>come up</source>
        <translation>angehoben werden</translation>
    </message>
    <message>
        <source>lead in</source>
        <translation>anfahren</translation>
    </message>
    <message>
        <source>lead out</source>
        <translation>abfahren</translation>
    </message>
    <message>
        <source>the lead-in</source>
        <translation>Anfahrweg</translation>
    </message>
    <message>
        <source>the lead-out</source>
        <translation>Abfahrweg</translation>
    </message>
    <message>
        <source>the transition at corner {}</source>
        <translation>Übergang an Ecke {}</translation>
    </message>
    <message>
        <source>the roll round corner {}</source>
        <translation>Abrollen um Ecke {}</translation>
    </message>
    <message>
        <source>the way along the contour</source>
        <translation>Weg entlang der Kontur</translation>
    </message>
    <message>
        <source>clearance</source>
        <translation>Sicherheitshöhe</translation>
    </message>
    <message>
        <source>grinding</source>
        <translation>Schleifhöhe</translation>
    </message>
    <message>
        <source>this Arris was built without them; install linuxcnc-uspace-dev and build it again</source>
        <translation>Dieses Arris wurde ohne sie gebaut; linuxcnc-uspace-dev installieren und neu bauen</translation>
    </message>
    <message>
        <source>install linuxcnc-uspace; {}</source>
        <translation>linuxcnc-uspace installieren; {}</translation>
    </message>
    <message>
        <source>the module is of another version of Arris</source>
        <translation>Das Modul gehört zu einer anderen Version von Arris</translation>
    </message>
    <message>
        <source>another Arris drives them already</source>
        <translation>Ein anderes Arris steuert sie bereits</translation>
    </message>
    <message>
        <source>this user may not reach the HAL session</source>
        <translation>Dieser Benutzer hat keinen Zugriff auf die HAL-Sitzung</translation>
    </message>
    <message>
        <source>HAL has no memory left</source>
        <translation>HAL hat keinen Speicher mehr</translation>
    </message>
    <message>
        <source>no HAL session for Arris runs; start one with packaging/hal/start.sh</source>
        <translation>Es läuft keine HAL-Sitzung für Arris; mit packaging/hal/start.sh starten</translation>
    </message>
    <message>
        <source>the HAL session has no signal {} that fits; compare its file with packaging/hal</source>
        <translation>Die HAL-Sitzung hat kein passendes Signal {}; ihre Datei mit packaging/hal vergleichen</translation>
    </message>
    <message>
        <source>the HAL session lacks streamer cfg=ffff or sampler cfg=fffff; compare its file with packaging/hal</source>
        <translation>Der HAL-Sitzung fehlt streamer cfg=ffff oder sampler cfg=fffff; ihre Datei mit packaging/hal vergleichen</translation>
    </message>
    <message>
        <source>an Arris that died has left the HAL session unfinished; start it again with packaging/hal/start.sh</source>
        <translation>Ein abgestürztes Arris hat die HAL-Sitzung unfertig hinterlassen; mit packaging/hal/start.sh neu starten</translation>
    </message>
    <message>
        <source>the threads of the HAL session do not run</source>
        <translation>Die Threads der HAL-Sitzung laufen nicht</translation>
    </message>
    <message>
        <source>the HAL session&apos;s streamer is not emptied, or somebody else fills it</source>
        <translation>Der streamer der HAL-Sitzung wird nicht geleert, oder jemand anderes füllt ihn</translation>
    </message>
    <message>
        <source>the HAL session&apos;s period is {} s, the machine&apos;s {} s</source>
        <translation>Der Takt der HAL-Sitzung ist {} s, der der Maschine {} s</translation>
    </message>
    <message>
        <source>knots</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>control points</source>
        <translation>Kontrollpunkte</translation>
    </message>
    <message>
        <source>fit points</source>
        <translation>Stützpunkte</translation>
    </message>
    <message>
        <source>X of its major axis</source>
        <translation>X der Hauptachse</translation>
    </message>
    <message>
        <source>Y of its major axis</source>
        <translation>Y der Hauptachse</translation>
    </message>
    <message>
        <source>ratio of its axes</source>
        <translation>Verhältnis der Achsen</translation>
    </message>
    <message>
        <source>a ratio of axes of</source>
        <translation>als Achsenverhältnis</translation>
    </message>
    <message>
        <source>name of the block</source>
        <translation>Name des Blocks</translation>
    </message>
    <message>
        <source>a major axis of</source>
        <translation>als Hauptachse</translation>
    </message>
    <message>
        <source>layer {} is not chosen</source>
        <translation>Layer {} ist nicht ausgewählt</translation>
    </message>
    <message>
        <source>block {} has no ENDBLK</source>
        <translation>Block {} hat kein ENDBLK</translation>
    </message>
    <message>
        <source>{} stands outside of any block</source>
        <translation>{} steht außerhalb der Blöcke</translation>
    </message>
    <message>
        <source>ENDBLK without a BLOCK</source>
        <translation>ENDBLK ohne BLOCK</translation>
    </message>
    <message>
        <source>its first line is broken</source>
        <translation>Ihre erste Zeile ist fehlerhaft</translation>
    </message>
    <message>
        <source>byte {} begins no group</source>
        <translation>Mit Byte {} beginnt keine Gruppe</translation>
    </message>
    <message>
        <source>it ends within the group at byte {}</source>
        <translation>Sie endet in der Gruppe bei Byte {}</translation>
    </message>
    <message>
        <source>its degree is {}; up to {} are read</source>
        <translation>Ihr Grad ist {}; bis {} wird gelesen</translation>
    </message>
    <message>
        <source>it has {} control points and needs {}</source>
        <translation>Sie hat {} Kontrollpunkte und braucht {}</translation>
    </message>
    <message>
        <source>it has {} knots and needs {}</source>
        <translation>Sie hat {} Knoten und braucht {}</translation>
    </message>
    <message>
        <source>its knots fall from {} to {}</source>
        <translation>Ihre Knoten fallen von {} auf {}</translation>
    </message>
    <message>
        <source>its knots are all the same</source>
        <translation>Ihre Knoten sind alle gleich</translation>
    </message>
    <message>
        <source>it has {} weights and needs {}</source>
        <translation>Sie hat {} Gewichte und braucht {}</translation>
    </message>
    <message>
        <source>it has a weight of {}, which is not positive</source>
        <translation>Sie hat ein Gewicht von {}, das nicht positiv ist</translation>
    </message>
    <message>
        <source>its weights reach from {} to {}</source>
        <translation>Ihre Gewichte reichen von {} bis {}</translation>
    </message>
    <message>
        <source>it breaks apart</source>
        <translation>Sie reißt auseinander</translation>
    </message>
    <message>
        <source>it does not begin like one</source>
        <translation>Sie beginnt nicht wie eine</translation>
    </message>
    <message>
        <source>its header is damaged</source>
        <translation>Ihr Kopf ist beschädigt</translation>
    </message>
    <message>
        <source>it breaks off</source>
        <translation>Sie bricht ab</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>Sie ist beschädigt</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>Datei zu groß</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>Die Datei ist leer</translation>
    </message>
    <message>
        <source>it has no rows</source>
        <translation>Sie hat keine Zeilen</translation>
    </message>
    <message>
        <source>the time does not increase</source>
        <translation>Die Zeit nimmt nicht zu</translation>
    </message>
    <message>
        <source>the column {} is missing</source>
        <translation>Die Spalte {} fehlt</translation>
    </message>
    <message>
        <source>the column {} stands twice</source>
        <translation>Die Spalte {} steht zweimal da</translation>
    </message>
    <message>
        <source>{} fields instead of {}</source>
        <translation>{} Felder statt {}</translation>
    </message>
    <message>
        <source>distance_mm must be empty where corner is 0</source>
        <translation>distance_mm muss leer sein, wo corner 0 ist</translation>
    </message>
    <message>
        <source>{} must be a finite number, not {}</source>
        <translation>{} muss eine endliche Zahl sein, nicht {}</translation>
    </message>
    <message>
        <source>{} must be a whole number from 0 on, not {}</source>
        <translation>{} muss eine ganze Zahl ab 0 sein, nicht {}</translation>
    </message>
    <message>
        <source>{} is no phase</source>
        <translation>{} ist keine Phase</translation>
    </message>
    <message>
        <source>it is no archive of Arris</source>
        <translation>Sie ist kein Archiv von Arris</translation>
    </message>
    <message>
        <source>it is damaged or cut off</source>
        <translation>Sie ist beschädigt oder abgeschnitten</translation>
    </message>
    <message>
        <source>it is larger than a back-up can be</source>
        <translation>Sie ist größer, als eine Sicherung sein kann</translation>
    </message>
    <message>
        <source>it does not say what it is</source>
        <translation>Sie sagt nicht, was sie ist</translation>
    </message>
    <message>
        <source>it is a support bundle</source>
        <translation>Sie ist ein Supportpaket</translation>
    </message>
    <message>
        <source>{} is no plain file</source>
        <translation>{} ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>{} stands there twice</source>
        <translation>{} steht zweimal da</translation>
    </message>
    <message>
        <source>{} is no part of a back-up</source>
        <translation>{} ist kein Teil einer Sicherung</translation>
    </message>
    <message>
        <source>{} is not valid</source>
        <translation>{} ist nicht gültig</translation>
    </message>
</context>
<context>
    <name>ProfilePage</name>
    <message>
        <source>Corner with its angle: from A to C</source>
        <translation>Ecke mit ihrem Winkel: von A bis C</translation>
    </message>
    <message>
        <source>Braking before, accelerating after</source>
        <translation>Davor bremsen, danach beschleunigen</translation>
    </message>
    <message>
        <source>Limit, feed, wheel radius R</source>
        <translation>Grenze, Vorschub, Schleifscheibenradius R</translation>
    </message>
    <message>
        <source>R + depth at the tip</source>
        <translation>R + Tiefe an der Spitze</translation>
    </message>
    <message>
        <source>Work %1 of %2 · wheel R %3 mm · feed %4 mm/min · acceleration X %5, Y %6 mm/s²</source>
        <translation>Arbeit %1 von %2 · Schleifscheibe R %3 mm · Vorschub %4 mm/min · Beschleunigung X %5, Y %6 mm/s²</translation>
    </message>
    <message>
        <source>Between contours</source>
        <translation>Zwischen Konturen</translation>
    </message>
    <message>
        <source>End of the travel</source>
        <translation>Ende des Verfahrbereichs</translation>
    </message>
    <message>
        <source>Way of the wheel&apos;s centre</source>
        <translation>Weg der Schleifscheibenmitte</translation>
    </message>
    <message>
        <source>In a corner, from A to C</source>
        <translation>In einer Ecke, von A bis C</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>Glas</translation>
    </message>
</context>
<context>
    <name>Quantities</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
</context>
<context>
    <name>Recipe</name>
    <message>
        <source>Wheel radius</source>
        <translation>Schleifscheibenradius</translation>
    </message>
    <message>
        <source>Thickness of the wheel</source>
        <translation>Dicke der Schleifscheibe</translation>
    </message>
    <message>
        <source>Fine adjustment of the grinding height</source>
        <translation>Feineinstellung der Schleifhöhe</translation>
    </message>
    <message>
        <source>Normal grinding depth</source>
        <translation>Schleiftiefe</translation>
    </message>
    <message>
        <source>Thickness of the glass</source>
        <translation>Glasdicke</translation>
    </message>
    <message>
        <source>Underside of the glass above the table</source>
        <translation>Glasunterseite über dem Tisch</translation>
    </message>
    <message>
        <source>Wheel&apos;s lower face above the glass when traversing</source>
        <translation>Unterseite der Schleifscheibe über dem Glas beim Umsetzen</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Acceleration of the X axis</source>
        <translation>Beschleunigung der X-Achse</translation>
    </message>
    <message>
        <source>Acceleration of the Y axis</source>
        <translation>Beschleunigung der Y-Achse</translation>
    </message>
    <message>
        <source>Acceleration of the Z axis</source>
        <translation>Beschleunigung der Z-Achse</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>Spindeldrehzahl</translation>
    </message>
    <message>
        <source>Transition speed at sharp corners</source>
        <translation>Übergangsgeschwindigkeit an spitzen Ecken</translation>
    </message>
    <message>
        <source>Size correction (positive leaves the pane larger)</source>
        <translation>Maßkorrektur (positiv lässt die Glasscheibe größer)</translation>
    </message>
    <message>
        <source>Radius of the lead-in and lead-out</source>
        <translation>Radius von An- und Abfahrweg</translation>
    </message>
    <message>
        <source>Overlap past the start</source>
        <translation>Überlappung über den Start hinaus</translation>
    </message>
    <message>
        <source>Rotation of the pattern</source>
        <translation>Drehung des Musters</translation>
    </message>
    <message>
        <source>Gaps up to this are closed</source>
        <translation>Lücken bis zu dieser Größe werden geschlossen</translation>
    </message>
    <message>
        <source>Tolerance of fitting chopped curves</source>
        <translation>Toleranz beim Glätten zerhackter Kurven</translation>
    </message>
    <message>
        <source>Accelerations bind</source>
        <translation>Beschleunigungen gelten</translation>
    </message>
    <message>
        <source>each axis</source>
        <translation>für jede Achse</translation>
    </message>
    <message>
        <source>X and Y together</source>
        <translation>für X und Y gemeinsam</translation>
    </message>
    <message>
        <source>Direction round the pane</source>
        <translation>Umlaufsinn um die Glasscheibe</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>counter-clockwise</source>
        <translation>gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Mirror the pattern</source>
        <translation>Muster spiegeln</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>left to right (X)</source>
        <translation>links-rechts (X)</translation>
    </message>
    <message>
        <source>top to bottom (Y)</source>
        <translation>oben-unten (Y)</translation>
    </message>
    <message>
        <source>Unit of the drawing</source>
        <translation>Einheit der Zeichnung</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>Fuß</translation>
    </message>
</context>
<context>
    <name>Services</name>
    <message>
        <source>Spindle: %1
Coolant: %2
Vacuum: %3</source>
        <translation>Spindel: %1
Kühlmittel: %2
Vakuum: %3</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>at speed</source>
        <translation>auf Drehzahl</translation>
    </message>
    <message>
        <source>comes up to speed</source>
        <translation>läuft hoch</translation>
    </message>
    <message>
        <source>flows</source>
        <translation>fließt</translation>
    </message>
    <message>
        <source>holds the glass</source>
        <translation>hält das Glas</translation>
    </message>
</context>
<context>
    <name>SimulatedFault</name>
    <message>
        <source>Coolant fails</source>
        <translation>Kühlmittel fällt aus</translation>
    </message>
    <message>
        <source>Spindle fails</source>
        <translation>Spindel fällt aus</translation>
    </message>
    <message>
        <source>Vacuum fails</source>
        <translation>Vakuum fällt aus</translation>
    </message>
    <message>
        <source>Drive of X fails</source>
        <translation>Antrieb X fällt aus</translation>
    </message>
    <message>
        <source>X is stuck</source>
        <translation>X ist blockiert</translation>
    </message>
    <message>
        <source>Emergency stop trips</source>
        <translation>Not-Halt löst aus</translation>
    </message>
</context>
<context>
    <name>Stage</name>
    <message>
        <source>Reading the drawing…</source>
        <translation>Zeichnung lesen…</translation>
    </message>
    <message>
        <source>Joining and fitting…</source>
        <translation>Verbinden und Glätten…</translation>
    </message>
    <message>
        <source>Laying the wheel path…</source>
        <translation>Schleifbahn berechnen…</translation>
    </message>
    <message>
        <source>Planning the speeds…</source>
        <translation>Geschwindigkeiten planen…</translation>
    </message>
    <message>
        <source>Computing the profile…</source>
        <translation>Profil berechnen…</translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <extracomment>What is under way, its number, and how many there are.</extracomment>
        <translation>%1 (%2 von %3)</translation>
    </message>
</context>
<context>
    <name>State</name>
    <message>
        <source>Drives off</source>
        <translation>Antriebe aus</translation>
    </message>
    <message>
        <source>Not homed</source>
        <translation>Nicht referenziert</translation>
    </message>
    <message>
        <source>Homing</source>
        <translation>Referenzfahrt</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Startet</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>Hält an</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Stepping</source>
        <translation>Schrittbetrieb</translation>
    </message>
    <message>
        <source>Jogging</source>
        <translation>Tippbetrieb</translation>
    </message>
    <message>
        <source>Positioning</source>
        <translation>Positionieren</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Stoppt</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>Not-Halt</translation>
    </message>
</context>
<context>
    <name>Wheel</name>
    <message>
        <source>%1, corner %2</source>
        <translation>%1, Ecke %2</translation>
    </message>
    <message>
        <source>%1 s of %2</source>
        <translation>%1 s von %2</translation>
    </message>
    <message>
        <source>%1 mm/s</source>
        <translation>%1 mm/s</translation>
    </message>
    <message>
        <source>%1 mm to the corner</source>
        <translation>%1 mm zur Ecke</translation>
    </message>
    <message>
        <source>Planned: X %1  Y %2  Z %3 mm</source>
        <translation>Geplant: X %1  Y %2  Z %3 mm</translation>
    </message>
</context>
<context>
    <name>arris::ui::AlarmBanner</name>
    <message>
        <source>Acknowledge</source>
        <translation>Quittieren</translation>
    </message>
    <message>
        <source>No job is loaded</source>
        <translation>Kein Auftrag geladen</translation>
    </message>
    <message>
        <source>%1 of %2 panes good</source>
        <translation>%1 von %2 Scheiben gut</translation>
    </message>
    <message>
        <source>Simulated axes</source>
        <translation>Simulierte Achsen</translation>
    </message>
    <message>
        <source>LinuxCNC: no axes</source>
        <translation>LinuxCNC: keine Achsen</translation>
    </message>
    <message>
        <source>Axes through LinuxCNC</source>
        <translation>Achsen über LinuxCNC</translation>
    </message>
    <message>
        <source> (+%1 on the page Alarms)</source>
        <translation> (+%1 auf der Seite „Alarme“)</translation>
    </message>
</context>
<context>
    <name>arris::ui::AlarmHistory</name>
    <message>
        <source>Reading the alarm log…</source>
        <translation>Alarmprotokoll wird gelesen…</translation>
    </message>
    <message>
        <source>Alarms: %1</source>
        <translation>Alarme: %1</translation>
    </message>
    <message>
        <source>Damaged lines of the alarm log, which cannot be read: %1</source>
        <translation>Beschädigte, nicht lesbare Zeilen des Alarmprotokolls: %1</translation>
    </message>
</context>
<context>
    <name>arris::ui::AlarmModel</name>
    <message>
        <source>State</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Code, axis, value</source>
        <translation>Code, Achse, Wert</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Ereignis</translation>
    </message>
</context>
<context>
    <name>arris::ui::AlarmPanel</name>
    <message>
        <source>Acknowledge</source>
        <translation>Quittieren</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Aktive</translation>
    </message>
    <message>
        <source>Tap an alarm to read its cause and what to do.</source>
        <translation>Einen Alarm antippen, um Ursache und Abhilfe zu lesen.</translation>
    </message>
    <message>
        <source>No alarm is active.</source>
        <translation>Kein Alarm ist aktiv.</translation>
    </message>
    <message>
        <source>There has been no alarm yet.</source>
        <translation>Bisher gab es keinen Alarm.</translation>
    </message>
</context>
<context>
    <name>arris::ui::AlarmTexts</name>
    <message>
        <source>active</source>
        <translation>aktiv</translation>
    </message>
    <message>
        <source>acknowledged</source>
        <translation>quittiert</translation>
    </message>
    <message>
        <source>not
acknowledged</source>
        <translation>nicht
quittiert</translation>
    </message>
    <message>
        <source>Cause: %1</source>
        <translation>Ursache: %1</translation>
    </message>
    <message>
        <source>What to do: %1</source>
        <translation>Abhilfe: %1</translation>
    </message>
    <message>
        <source>Record of the run: %1</source>
        <translation>Aufzeichnung des Laufs: %1</translation>
    </message>
</context>
<context>
    <name>arris::ui::AlarmsPage</name>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation>Ein- und Ausgänge</translation>
    </message>
    <message>
        <source>Counters and back-up</source>
        <translation>Zähler und Sicherung</translation>
    </message>
</context>
<context>
    <name>arris::ui::BackUpPanel</name>
    <message>
        <source>In the machine&apos;s life</source>
        <translation>Über die Lebensdauer</translation>
    </message>
    <message>
        <source>So far</source>
        <translation>Bisher</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Einlesen</translation>
    </message>
    <message>
        <source>Keep as it is</source>
        <translation>So lassen</translation>
    </message>
    <message>
        <source>Reading or writing</source>
        <translation>Lesen oder Schreiben</translation>
    </message>
    <message>
        <source>Settings, machine, recipes and counters</source>
        <translation>Einstellungen, Maschine, Rezepte und Zähler</translation>
    </message>
    <message>
        <source>Back up…</source>
        <translation>Sichern …</translation>
    </message>
    <message>
        <source>Saves all of them in one file.</source>
        <translation>Speichert sie alle in einer Datei.</translation>
    </message>
    <message>
        <source>Restore…</source>
        <translation>Einlesen …</translation>
    </message>
    <message>
        <source>Brings them back from such a file: while nothing moves and no job is loaded.</source>
        <translation>Stellt sie aus einer solchen Datei wieder her: nur solange sich nichts bewegt und kein Auftrag geladen ist.</translation>
    </message>
    <message>
        <source>Support bundle…</source>
        <translation>Supportpaket …</translation>
    </message>
    <message>
        <source>Saves them with the alarm log, the last runs and versions, for whoever helps.</source>
        <translation>Speichert sie mit Alarmprotokoll, den letzten Läufen und den Versionen, für alle, die helfen.</translation>
    </message>
    <message>
        <source>Reading or writing…</source>
        <translation>Lesen oder Schreiben …</translation>
    </message>
    <message>
        <source>Archives (*.tar.gz);;All files (*)</source>
        <translation>Archive (*.tar.gz);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Back up</source>
        <translation>Sichern</translation>
    </message>
    <message>
        <source>Support bundle</source>
        <translation>Supportpaket</translation>
    </message>
    <message>
        <source>Restore a back-up</source>
        <translation>Sicherung einlesen</translation>
    </message>
</context>
<context>
    <name>arris::ui::BackUps</name>
    <message>
        <source>Saved: %1. It has what help needs; nothing is sent to anybody.</source>
        <translation>Gespeichert: %1. Darin ist, was zum Helfen nötig ist; es wird niemandem etwas gesendet.</translation>
    </message>
    <message>
        <source>There is nothing to back up yet: no settings, machine, recipes or counters have been kept so far.</source>
        <translation>Es gibt noch nichts zu sichern: Bisher wurden weder Einstellungen noch Maschine, Rezepte oder Zähler gespeichert.</translation>
    </message>
    <message>
        <source>Saved: %1. Files in it: %2.</source>
        <translation>Gespeichert: %1. Dateien darin: %2.</translation>
    </message>
    <message>
        <source>Restore the back-up of %1? Its files (%2) replace settings, machine, recipes and counters of the same names. What is there now is kept as a back-up.</source>
        <translation>Sicherung vom %1 einlesen? Ihre Dateien (%2) ersetzen gleichnamige Einstellungen, Maschine, Rezepte und Zähler. Der jetzige Stand wird als Sicherung aufgehoben.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Es wurde nichts geändert.</translation>
    </message>
    <message>
        <source>What was there before is in %1.</source>
        <translation>Der vorherige Stand liegt in %1.</translation>
    </message>
    <message>
        <source>Restored. Close Arris and start it again: then it takes effect.</source>
        <translation>Eingelesen. Arris schließen und neu starten: Dann wird es wirksam.</translation>
    </message>
</context>
<context>
    <name>arris::ui::BusyRow</name>
    <message>
        <source>Cancel</source>
        <translation>Abbruch</translation>
    </message>
</context>
<context>
    <name>arris::ui::ByHandPanel</name>
    <message>
        <source>Origin of the table (G54)</source>
        <translation>Nullpunkt des Tisches (G54)</translation>
    </message>
    <message>
        <source>Zero of the table in X</source>
        <translation>Tischnullpunkt in X</translation>
    </message>
    <message>
        <source>Zero of the table in Y</source>
        <translation>Tischnullpunkt in Y</translation>
    </message>
    <message>
        <source>Zero of the table in Z</source>
        <translation>Tischnullpunkt in Z</translation>
    </message>
    <message>
        <source>Set here</source>
        <translation>Hier Null</translation>
    </message>
    <message>
        <source>The table&apos;s zero of %1 is where the wheel is</source>
        <translation>Der Tischnullpunkt in %1 ist dort, wo die Schleifscheibe steht</translation>
    </message>
    <message>
        <source>Set the typed origin</source>
        <translation>Eingabe übernehmen</translation>
    </message>
    <message>
        <source>Support of the glass</source>
        <translation>Auflage des Glases</translation>
    </message>
    <message>
        <source>Spindle and coolant by hand</source>
        <translation>Spindel und Kühlmittel von Hand</translation>
    </message>
    <message>
        <source>Spindle speed by hand</source>
        <translation>Spindeldrehzahl von Hand</translation>
    </message>
    <message>
        <source>Spindle on</source>
        <translation>Spindel ein</translation>
    </message>
    <message>
        <source>Spindle off</source>
        <translation>Spindel aus</translation>
    </message>
    <message>
        <source>Coolant on</source>
        <translation>Kühlmittel ein</translation>
    </message>
    <message>
        <source>Coolant off</source>
        <translation>Kühlmittel aus</translation>
    </message>
    <message>
        <source>A pane was broken off: its origin stays until it has been ground or given up.</source>
        <translation>Das Schleifen einer Glasscheibe wurde abgebrochen: Ihr Nullpunkt bleibt, bis sie geschliffen oder aufgegeben ist.</translation>
    </message>
    <message>
        <source>Where the zero of the table lies in machine coordinates. Whether the job still fits into the travel is checked at once.</source>
        <translation>Wo der Tischnullpunkt in Maschinenkoordinaten liegt. Ob der Auftrag noch in den Verfahrbereich passt, wird sofort geprüft.</translation>
    </message>
    <message>
        <source>The origin can be set when the axes are homed and at rest.</source>
        <translation>Der Nullpunkt lässt sich setzen, wenn die Achsen referenziert sind und stillstehen.</translation>
    </message>
    <message>
        <source>No job is loaded: its recipe says how high the glass lies.</source>
        <translation>Kein Auftrag geladen: Das Rezept des Auftrags gibt an, wie hoch das Glas liegt.</translation>
    </message>
    <message>
        <source>Of the job that is loaded: the underside of the glass lies %1 mm above the table, the glass is %2 mm thick, and the middle of the wheel grinds at Z %3 mm.</source>
        <translation>Zum geladenen Auftrag: Die Glasunterseite liegt %1 mm über dem Tisch, das Glas ist %2 mm dick, und die Mitte der Schleifscheibe schleift bei Z %3 mm.</translation>
    </message>
</context>
<context>
    <name>arris::ui::ControlStrip</name>
    <message>
        <source>FEED
HOLD</source>
        <translation>VORSCHUB
HALT</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOPP</translation>
    </message>
    <message>
        <source>Lock
30 s</source>
        <translation>Sperre
30 s</translation>
    </message>
    <message>
        <source>Lock the screen for 30 s to wipe it</source>
        <translation>Bildschirm für 30 s sperren, um ihn abzuwischen</translation>
    </message>
</context>
<context>
    <name>arris::ui::CornerCard</name>
    <message>
        <source>Tap a corner to see its figures.</source>
        <translation>Eine Ecke antippen, um ihre Werte zu sehen.</translation>
    </message>
    <message>
        <source>No corners.</source>
        <translation>Keine Ecken.</translation>
    </message>
    <message>
        <source>Corner %1: %2, %3</source>
        <translation>Ecke %1: %2, %3</translation>
    </message>
    <message>
        <source>Speed v&lt;sub&gt;trans&lt;/sub&gt;</source>
        <translation>Geschw. v&lt;sub&gt;trans&lt;/sub&gt;</translation>
    </message>
    <message>
        <source>%1 mm/s, %2</source>
        <translation>%1 mm/s, %2</translation>
    </message>
    <message>
        <source>Blending a, t&lt;sub&gt;m&lt;/sub&gt;</source>
        <translation>Übergang a, t&lt;sub&gt;m&lt;/sub&gt;</translation>
    </message>
    <message>
        <source>%1 mm/s²; %2 s</source>
        <translation>%1 mm/s²; %2 s</translation>
    </message>
    <message>
        <source>Widest, leg ℓ</source>
        <translation>Abstand, ℓ</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>Freigang</translation>
    </message>
    <message>
        <source>yes: lifts %1; needs %2 mm</source>
        <translation>ja: hebt %1; nötig %2 mm</translation>
    </message>
    <message>
        <source>no: lifts %1; needs %2 mm</source>
        <translation>nein: hebt %1; nötig %2 mm</translation>
    </message>
    <message>
        <source>Radius of the roll</source>
        <translation>Abrollradius</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>Geplant</translation>
    </message>
    <message>
        <source>%1 mm/s; %2 s</source>
        <translation>%1 mm/s; %2 s</translation>
    </message>
    <message>
        <source>Slowing L&lt;sub&gt;d&lt;/sub&gt;, L&lt;sub&gt;a&lt;/sub&gt;</source>
        <translation>Rampen L&lt;sub&gt;d&lt;/sub&gt;, L&lt;sub&gt;a&lt;/sub&gt;</translation>
    </message>
    <message>
        <source>%1; %2 mm</source>
        <translation>%1; %2 mm</translation>
    </message>
    <message>
        <source>(contour %1)</source>
        <translation>(Kontur %1)</translation>
    </message>
    <message>
        <source>Glass left</source>
        <translation>Glas bleibt</translation>
    </message>
    <message>
        <source>%1 mm before the corner</source>
        <translation>%1 mm vor der Ecke</translation>
    </message>
    <message>
        <source>Not ground</source>
        <translation>Ungeschliffen</translation>
    </message>
    <message>
        <source>%1 mm of its edges</source>
        <translation>%1 mm der Kanten</translation>
    </message>
    <message>
        <source>Distance between wheel and corner over time</source>
        <translation>Abstand zwischen Schleifscheibe und Ecke über der Zeit</translation>
    </message>
</context>
<context>
    <name>arris::ui::CornerModel</name>
    <message>
        <source>#</source>
        <translation>#</translation>
    </message>
    <message>
        <source>Angle
β</source>
        <translation>Winkel
β</translation>
    </message>
    <message>
        <source>Treatment</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Speed
mm/s</source>
        <translation>v
mm/s</translation>
    </message>
    <message>
        <source>Accel.
mm/s²</source>
        <translation>a
mm/s²</translation>
    </message>
    <message>
        <source>Time
s</source>
        <translation>Zeit
s</translation>
    </message>
    <message>
        <source>Widest
mm</source>
        <translation>Abst.
mm</translation>
    </message>
    <message>
        <source>Relief
mm</source>
        <translation>Freigang
mm</translation>
    </message>
</context>
<context>
    <name>arris::ui::Diagnosis</name>
    <message>
        <source>Drive ready</source>
        <translation>Antrieb bereit</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>pressed</source>
        <translation>gedrückt</translation>
    </message>
    <message>
        <source>released</source>
        <translation>gelöst</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>hit</source>
        <translation>belegt</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>Limit switch, low end</source>
        <translation>Endschalter, unteres Ende</translation>
    </message>
    <message>
        <source>Limit switch, high end</source>
        <translation>Endschalter, oberes Ende</translation>
    </message>
    <message>
        <source>Reference switch</source>
        <translation>Referenzschalter</translation>
    </message>
    <message>
        <source>Drive enable (output)</source>
        <translation>Antriebsfreigabe (Ausgang)</translation>
    </message>
    <message>
        <source>Drive fault</source>
        <translation>Antriebsstörung</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Encoder</source>
        <translation>Geber</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Following error, mm</source>
        <translation>Schleppfehler, mm</translation>
    </message>
    <message>
        <source>At worst since the start, mm</source>
        <translation>Größter seit dem Start, mm</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>Not-Halt</translation>
    </message>
    <message>
        <source>tripped</source>
        <translation>ausgelöst</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>Spindel</translation>
    </message>
    <message>
        <source>at speed</source>
        <translation>auf Drehzahl</translation>
    </message>
    <message>
        <source>not at speed</source>
        <translation>nicht auf Drehzahl</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>Kühlmittel</translation>
    </message>
    <message>
        <source>flows</source>
        <translation>fließt</translation>
    </message>
    <message>
        <source>does not flow</source>
        <translation>fließt nicht</translation>
    </message>
    <message>
        <source>Vacuum</source>
        <translation>Vakuum</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>hält</translation>
    </message>
    <message>
        <source>does not hold</source>
        <translation>hält nicht</translation>
    </message>
    <message>
        <source>Button cycle start</source>
        <translation>Taster Zyklusstart</translation>
    </message>
    <message>
        <source>Button feed hold</source>
        <translation>Taster Vorschub-Halt</translation>
    </message>
    <message>
        <source>Button stop</source>
        <translation>Taster Stopp</translation>
    </message>
    <message>
        <source>Button jog enable</source>
        <translation>Taster Tippfreigabe</translation>
    </message>
    <message>
        <source>Override selector</source>
        <translation>Override-Vorwahl</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 r/min</source>
        <translation>%1 U/min</translation>
    </message>
    <message>
        <source>Heartbeat</source>
        <translation>Lebenszeichen</translation>
    </message>
    <message>
        <source>beats</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>stands still</source>
        <translation>steht</translation>
    </message>
    <message>
        <source>Least lead, periods</source>
        <translation>Kleinster Vorlauf, Takte</translation>
    </message>
    <message>
        <source>Late wake-ups</source>
        <translation>Verspätete Takte</translation>
    </message>
    <message>
        <source>Latest wake-up, ms</source>
        <translation>Größte Verspätung, ms</translation>
    </message>
    <message>
        <source>Buffered pairs</source>
        <translation>Gepufferte Paare</translation>
    </message>
    <message>
        <source>Lost reports</source>
        <translation>Verlorene Meldungen</translation>
    </message>
    <message>
        <source>Refused commands</source>
        <translation>Abgelehnte Befehle</translation>
    </message>
    <message>
        <source>Drives on</source>
        <translation>Antriebe ein</translation>
    </message>
    <message>
        <source>Spindle on</source>
        <translation>Spindel ein</translation>
    </message>
    <message>
        <source>Grinding</source>
        <translation>Schleifen</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Geschliffen</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Panes ground</source>
        <translation>Scheiben geschliffen</translation>
    </message>
    <message>
        <source>Counted since</source>
        <translation>Gezählt seit</translation>
    </message>
</context>
<context>
    <name>arris::ui::DiagnosisPanel</name>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Ist</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Eingänge</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Ausgänge</translation>
    </message>
</context>
<context>
    <name>arris::ui::DrawingView</name>
    <message>
        <source>Drawing</source>
        <translation>Zeichnung</translation>
    </message>
    <message>
        <source>Open a pattern (DXF), or drop one here.</source>
        <translation>Ein Muster (DXF) öffnen oder hierher ziehen.</translation>
    </message>
</context>
<context>
    <name>arris::ui::FindingsPanel</name>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Zeiten</translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation>Probleme (%1)</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
</context>
<context>
    <name>arris::ui::HelpPage</name>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>en</source>
        <comment>language of the manual</comment>
        <extracomment>The language that the manual is read in: that of this translation, &quot;de&quot; or &quot;zh_CN&quot;.</extracomment>
        <translation>de</translation>
    </message>
</context>
<context>
    <name>arris::ui::JobPage</name>
    <message>
        <source>Drawing</source>
        <translation>Zeichnung</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>Planning</source>
        <translation>Planung läuft</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Fit into the view</source>
        <translation>In die Ansicht einpassen</translation>
    </message>
    <message>
        <source>Reading and planning…</source>
        <translation>Wird gelesen und geplant…</translation>
    </message>
    <message>
        <source>No pattern is open.</source>
        <translation>Kein Muster geöffnet.</translation>
    </message>
    <message>
        <source>Cannot be ground: see the problems.</source>
        <translation>Nicht schleifbar: siehe Probleme.</translation>
    </message>
    <message>
        <source>Cancelled. Open a pattern.</source>
        <translation>Abgebrochen. Muster öffnen.</translation>
    </message>
    <message>
        <source>Cancelled: no profile.
To plan: change a value.</source>
        <translation>Abgebrochen: kein Profil.
Zum Planen: Wert ändern.</translation>
    </message>
    <message>
        <source>Cancelled: values before.
To plan: change a value.</source>
        <translation>Abgebrochen: Werte von vorher.
Zum Planen: Wert ändern.</translation>
    </message>
    <message>
        <source>Grinding: %1
Program: %2</source>
        <translation>Schleifen: %1
Programm: %2</translation>
    </message>
</context>
<context>
    <name>arris::ui::Keypad</name>
    <message>
        <source>Cancel</source>
        <translation>Abbruch</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
</context>
<context>
    <name>arris::ui::MainWindow</name>
    <message>
        <source>%1 – Arris</source>
        <translation>%1 – Arris</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Auftrag</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Einrichten</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Betrieb</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Profile</translation>
    </message>
    <message>
        <source>The machine is moving</source>
        <translation>Die Maschine ist in Bewegung</translation>
    </message>
    <message>
        <source>Stop the machine and close Arris? The job can be resumed later.</source>
        <translation>Maschine stoppen und Arris schließen? Der Auftrag kann später fortgesetzt werden.</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>Stoppen und schließen</translation>
    </message>
    <message>
        <source>Keep running</source>
        <translation>Weiterlaufen lassen</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
</context>
<context>
    <name>arris::ui::NumberEdit</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>von %1 bis %2</translation>
    </message>
    <message>
        <source>%1: type a number %2.</source>
        <translation>%1: Bitte eine Zahl %2 eingeben.</translation>
    </message>
    <message>
        <source>%1: “%2” can mean %3 or %4; type it that way.</source>
        <translation>%1: „%2“ kann %3 oder %4 heißen; bitte so eingeben.</translation>
    </message>
    <message>
        <source>%1 is not a number; type one %2.</source>
        <translation>%1: Das ist keine Zahl; bitte eine %2 eingeben.</translation>
    </message>
    <message>
        <source>%1 is out of range; it must be %2.</source>
        <translation>%1: Bitte einen Wert %2 eingeben.</translation>
    </message>
</context>
<context>
    <name>arris::ui::OrderPanel</name>
    <message>
        <source>Good</source>
        <translation>Gut</translation>
    </message>
    <message>
        <source>The pane is good</source>
        <translation>Die Scheibe ist gut</translation>
    </message>
    <message>
        <source>Reject</source>
        <translation>Ausschuss</translation>
    </message>
    <message>
        <source>The pane is a reject</source>
        <translation>Die Scheibe ist Ausschuss</translation>
    </message>
    <message>
        <source>Fewer panes</source>
        <translation>Weniger Scheiben</translation>
    </message>
    <message>
        <source>More panes</source>
        <translation>Mehr Scheiben</translation>
    </message>
    <message>
        <source>Grind the next pane smaller</source>
        <translation>Nächste Scheibe kleiner schleifen</translation>
    </message>
    <message>
        <source>Leave the next pane larger</source>
        <translation>Nächste Scheibe größer lassen</translation>
    </message>
    <message>
        <source>Size correction, next pane</source>
        <translation>Maßkorrektur, nächste Scheibe</translation>
    </message>
    <message>
        <source>More leaves the pane larger.</source>
        <translation>Mehr lässt die Scheibe größer.</translation>
    </message>
    <message>
        <source>Pane %1 of %2: %3 good, %4 rejected</source>
        <translation>Scheibe %1 von %2: %3 gut, %4 Ausschuss</translation>
    </message>
    <message>
        <source>Load for the next pane</source>
        <translation>Für nächste Scheibe laden</translation>
    </message>
    <message>
        <source>Load job</source>
        <translation>Auftrag laden</translation>
    </message>
    <message>
        <source>The pane is interrupted: resume it, or stop it, before a job is loaded.</source>
        <translation>Die Scheibe ist unterbrochen: fortsetzen oder stoppen, bevor ein Auftrag geladen wird.</translation>
    </message>
    <message>
        <source>Values have changed; this pane stays as it was loaded. After it load the job for the next pane.</source>
        <translation>Werte haben sich geändert; diese Scheibe bleibt, wie sie geladen wurde. Danach den Auftrag für die nächste Scheibe laden.</translation>
    </message>
    <message>
        <source>Pane %1 has ended: good or reject? Changed since it was loaded: load the job again for the next pane.</source>
        <translation>Scheibe %1 ist beendet: gut oder Ausschuss? Seit dem Laden geändert: für die nächste Scheibe Auftrag neu laden.</translation>
    </message>
    <message>
        <source>Changed since it was loaded: load the job again for the next pane.</source>
        <translation>Seit dem Laden geändert: für die nächste Scheibe Auftrag neu laden.</translation>
    </message>
    <message>
        <source>Pane %1 has ended: good or reject? It counts as good when the next one begins.</source>
        <translation>Scheibe %1 ist beendet: gut oder Ausschuss? Sie zählt als gut, wenn die nächste beginnt.</translation>
    </message>
    <message>
        <source>The order is complete.</source>
        <translation>Die Serie ist fertig.</translation>
    </message>
    <message>
        <source>The page Job shows other values than it has: nothing can be loaded before they are planned.</source>
        <translation>Die Seite „Auftrag“ zeigt andere Werte als die geplanten: Erst wenn sie geplant sind, kann geladen werden.</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>Scheiben</translation>
    </message>
    <message>
        <source>What is planned on the page Job cannot be ground: nothing can be loaded before that is put right.</source>
        <translation>Was auf der Seite „Auftrag“ geplant ist, kann nicht geschliffen werden: Erst wenn das behoben ist, kann geladen werden.</translation>
    </message>
    <message>
        <source>Pane %1 was broken off. After the alarm CYCLE START goes on with it; “Reject”, or loading a job, gives it up.</source>
        <translation>Scheibe %1 wurde abgebrochen. Nach dem Alarm setzt ZYKLUSSTART sie fort; „Ausschuss“ oder „Auftrag laden“ verwirft sie.</translation>
    </message>
    <message>
        <source>Pane %1 was broken off: CYCLE START goes on with it. “Reject”, or loading a job, gives it up.</source>
        <translation>Scheibe %1 wurde abgebrochen: ZYKLUSSTART setzt sie fort; „Ausschuss“ oder „Auftrag laden“ verwirft sie.</translation>
    </message>
</context>
<context>
    <name>arris::ui::PathPlot</name>
    <message>
        <source>X, mm</source>
        <translation>X, mm</translation>
    </message>
    <message>
        <source>Y, mm</source>
        <translation>Y, mm</translation>
    </message>
</context>
<context>
    <name>arris::ui::PatternDialog</name>
    <message>
        <source>Open pattern</source>
        <translation>Muster öffnen</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbruch</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Here are neither drawings (*.dxf) nor folders.</source>
        <translation>Hier sind weder Zeichnungen (*.dxf) noch Ordner.</translation>
    </message>
    <message>
        <source>No pattern was opened yet, or none is still there.</source>
        <translation>Noch kein Muster wurde geöffnet, oder keines ist mehr da.</translation>
    </message>
</context>
<context>
    <name>arris::ui::PatternPanel</name>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>There is nothing to show.</source>
        <translation>Es gibt nichts zu zeigen.</translation>
    </message>
    <message>
        <source>Tap a pattern to see it.</source>
        <translation>Zum Ansehen Muster antippen.</translation>
    </message>
    <message>
        <source>Unit of the drawing: %1, assumed</source>
        <translation>Einheit der Zeichnung: %1, angenommen</translation>
    </message>
    <message>
        <source>Unit of the drawing: %1</source>
        <translation>Einheit der Zeichnung: %1</translation>
    </message>
</context>
<context>
    <name>arris::ui::PatternView</name>
    <message>
        <source>Drawing</source>
        <translation>Zeichnung</translation>
    </message>
</context>
<context>
    <name>arris::ui::ProblemModel</name>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>Repaired</source>
        <translation>Repariert</translation>
    </message>
</context>
<context>
    <name>arris::ui::ProfilePlot</name>
    <message>
        <source>time, s</source>
        <translation>Zeit in s</translation>
    </message>
    <message>
        <source>X velocity
mm/s</source>
        <translation>X-Geschw.
mm/s</translation>
    </message>
    <message>
        <source>v X
mm/s</source>
        <translation>v X
mm/s</translation>
    </message>
    <message>
        <source>Y velocity
mm/s</source>
        <translation>Y-Geschw.
mm/s</translation>
    </message>
    <message>
        <source>v Y
mm/s</source>
        <translation>v Y
mm/s</translation>
    </message>
    <message>
        <source>X acceleration
mm/s²</source>
        <translation>X-Beschl.
mm/s²</translation>
    </message>
    <message>
        <source>a X
mm/s²</source>
        <translation>a X
mm/s²</translation>
    </message>
    <message>
        <source>Y acceleration
mm/s²</source>
        <translation>Y-Beschl.
mm/s²</translation>
    </message>
    <message>
        <source>a Y
mm/s²</source>
        <translation>a Y
mm/s²</translation>
    </message>
    <message>
        <source>Path speed
mm/s</source>
        <translation>Bahngeschw.
mm/s</translation>
    </message>
    <message>
        <source>v
mm/s</source>
        <translation>v
mm/s</translation>
    </message>
    <message>
        <source>Wheel to corner
mm</source>
        <translation>Abstand zur Ecke
mm</translation>
    </message>
    <message>
        <source>L
mm</source>
        <translation>L
mm</translation>
    </message>
    <message>
        <source>limit %1</source>
        <translation>Grenze %1</translation>
    </message>
    <message>
        <source>feed %1</source>
        <translation>Vorschub %1</translation>
    </message>
    <message>
        <source>X position
mm</source>
        <translation>X-Position
mm</translation>
    </message>
    <message>
        <source>X
mm</source>
        <translation>X
mm</translation>
    </message>
    <message>
        <source>Y position
mm</source>
        <translation>Y-Position
mm</translation>
    </message>
    <message>
        <source>Y
mm</source>
        <translation>Y
mm</translation>
    </message>
    <message>
        <source>travel %1</source>
        <translation>Endlage %1</translation>
    </message>
</context>
<context>
    <name>arris::ui::ProfilesPage</name>
    <message>
        <source>Open…</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Open an exported profile or the record of a run</source>
        <translation>Ein exportiertes Profil oder die Aufzeichnung eines Laufs öffnen</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>Geplant</translation>
    </message>
    <message>
        <source>Back to the planned profile alone</source>
        <translation>Zurück zum geplanten Profil allein</translation>
    </message>
    <message>
        <source>Over the plan</source>
        <translation>Über dem Plan</translation>
    </message>
    <message>
        <source>Show the plan under the open file</source>
        <translation>Den Plan unter der geöffneten Datei zeigen</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Bild …</translation>
    </message>
    <message>
        <source>Save a picture as SVG, PNG or PDF</source>
        <translation>Ein Bild als SVG, PNG oder PDF speichern</translation>
    </message>
    <message>
        <source>Previous corner</source>
        <translation>Vorige Ecke</translation>
    </message>
    <message>
        <source>Next corner</source>
        <translation>Nächste Ecke</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Schleifen</translation>
    </message>
    <message>
        <source>From the first lead-in to the last lead-out</source>
        <translation>Vom ersten Anfahren bis zum letzten Abfahren</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Reading or writing…</source>
        <translation>Lesen oder Schreiben …</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>%1, drawn thin over the plan, which is wide and pale</source>
        <translation>%1, dünn über dem Plan gezeichnet; er ist breit und blass</translation>
    </message>
    <message>
        <source>Planned: %1</source>
        <translation>Geplant: %1</translation>
    </message>
    <message>
        <source>Planning…</source>
        <translation>Planen …</translation>
    </message>
    <message>
        <source>The pattern cannot be ground: there is no planned profile.</source>
        <translation>Das Muster ist nicht schleifbar: Es gibt kein geplantes Profil.</translation>
    </message>
    <message>
        <source>No pattern is open. Profiles and records of runs can be opened all the same.</source>
        <translation>Kein Muster ist geöffnet. Profile und Aufzeichnungen von Läufen lassen sich trotzdem öffnen.</translation>
    </message>
    <message>
        <source>Open profile or record</source>
        <translation>Profil oder Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Records and profiles (*.arrisrun *.csv *.CSV);;All files (*)</source>
        <translation>Aufzeichnungen und Profile (*.arrisrun *.csv *.CSV);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Profile…</source>
        <translation>Profil …</translation>
    </message>
    <message>
        <source>Save the profile as a table (CSV)</source>
        <translation>Das Profil als Tabelle (CSV) speichern</translation>
    </message>
    <message>
        <source>Job sheet…</source>
        <translation>Blatt …</translation>
    </message>
    <message>
        <source>Save drawing, values, corners and times of the job as PDF</source>
        <translation>Zeichnung, Werte, Ecken und Zeiten des Auftrags als PDF speichern</translation>
    </message>
    <message>
        <source>Speeds</source>
        <translation>Geschw.</translation>
    </message>
    <message>
        <source>Velocities, accelerations and distance to the corner over time</source>
        <translation>Geschwindigkeiten, Beschleunigungen und Abstand zur Ecke über der Zeit</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Positionen</translation>
    </message>
    <message>
        <source>X and Y over time</source>
        <translation>X und Y über der Zeit</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>The way of the wheel in the plane</source>
        <translation>Der Weg der Schleifscheibe in der Ebene</translation>
    </message>
    <message>
        <source>From the start of the program to its end; of the path: all of the travel</source>
        <translation>Vom Anfang des Programms bis zu seinem Ende; bei der Bahn: der ganze Verfahrbereich</translation>
    </message>
    <message>
        <source>%1, corner %2</source>
        <translation>%1, Ecke %2</translation>
    </message>
    <message>
        <source>Save the profile of the run %1</source>
        <translation>Profil des Laufs %1 speichern</translation>
    </message>
    <message>
        <source>Save the planned profile</source>
        <translation>Geplantes Profil speichern</translation>
    </message>
    <message>
        <source>Save job sheet</source>
        <translation>Auftragsblatt speichern</translation>
    </message>
</context>
<context>
    <name>arris::ui::RecipeBook</name>
    <message>
        <source>%1, wheel R %2</source>
        <translation>%1, Schleifscheibe R %2</translation>
    </message>
</context>
<context>
    <name>arris::ui::RecipeDialog</name>
    <message>
        <source>Recipes (*.json);;All files (*)</source>
        <translation>Rezepte (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importieren…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Ja</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nein</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Rezepte</translation>
    </message>
    <message>
        <source>All recipes</source>
        <translation>Alle Rezepte</translation>
    </message>
    <message>
        <source>For the glass thickness set now</source>
        <translation>Für die eingestellte Glasdicke</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Save the values in effect as</source>
        <translation>Geltende Werte speichern als</translation>
    </message>
    <message>
        <source>“%1” is in effect.</source>
        <translation>„%1“ gilt jetzt.</translation>
    </message>
    <message>
        <source>Saved as “%1”.</source>
        <translation>Gespeichert als „%1“.</translation>
    </message>
    <message>
        <source>Replace “%1” by the values in effect?</source>
        <translation>„%1“ durch die geltenden Werte ersetzen?</translation>
    </message>
    <message>
        <source>Delete “%1”?</source>
        <translation>„%1“ löschen?</translation>
    </message>
    <message>
        <source>“%1” is deleted.</source>
        <translation>„%1“ ist gelöscht.</translation>
    </message>
    <message>
        <source>Import a recipe</source>
        <translation>Rezept importieren</translation>
    </message>
    <message>
        <source>Imported as “%1”; it is not in effect yet.</source>
        <translation>Importiert als „%1“; gilt noch nicht.</translation>
    </message>
    <message>
        <source>Replace “%1” by the file?</source>
        <translation>„%1“ durch die Datei ersetzen?</translation>
    </message>
    <message>
        <source>Export a recipe</source>
        <translation>Rezept exportieren</translation>
    </message>
    <message>
        <source>“%1” is written to %2.</source>
        <translation>„%1“ ist in %2 gespeichert.</translation>
    </message>
    <message>
        <source>No recipe has been saved yet.</source>
        <translation>Es ist noch kein Rezept gespeichert.</translation>
    </message>
    <message>
        <source>No recipe is for this thickness of glass.</source>
        <translation>Für diese Glasdicke gibt es kein Rezept.</translation>
    </message>
</context>
<context>
    <name>arris::ui::RecipeFields</name>
    <message>
        <source>Heights</source>
        <translation>Höhen</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>On the table</source>
        <translation>Auf dem Tisch</translation>
    </message>
    <message>
        <source>Lower left corner of the pane</source>
        <translation>Linke untere Ecke der Glasscheibe</translation>
    </message>
    <message>
        <source>Centred on the table</source>
        <translation>Mittig auf dem Tisch</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Start near this place</source>
        <translation>Start möglichst nahe bei</translation>
    </message>
    <message>
        <source>Left to Arris</source>
        <translation>Arris überlassen</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Zeichnung</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>wie in der Datei</translation>
    </message>
    <message>
        <source>Leave unground what
the wheel cannot reach</source>
        <translation>Unerreichbares bleibt
ungeschliffen</translation>
    </message>
    <message>
        <source>Only these layers (none chosen: all)</source>
        <translation>Nur diese Layer (keiner gewählt: alle)</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Layer</translation>
    </message>
    <message>
        <source>Rim speed: %1 m/s</source>
        <translation>Umfangsgeschw.: %1 m/s</translation>
    </message>
    <message>
        <source>The drawing still shows the last valid values.</source>
        <translation>Die Zeichnung zeigt noch die letzten gültigen Werte.</translation>
    </message>
</context>
<context>
    <name>arris::ui::RecipeModel</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Glass
mm</source>
        <translation>Glas
mm</translation>
    </message>
    <message>
        <source>Wheel
mm</source>
        <translation>Schleifsch.
mm</translation>
    </message>
    <message>
        <source>Depth
mm</source>
        <translation>Tiefe
mm</translation>
    </message>
    <message>
        <source>Feed
mm/min</source>
        <translation>Vorschub
mm/min</translation>
    </message>
</context>
<context>
    <name>arris::ui::RecipePanel</name>
    <message>
        <source>No pattern yet</source>
        <translation>Noch kein Muster</translation>
    </message>
    <message>
        <source>Grinding</source>
        <translation>Schleifen</translation>
    </message>
    <message>
        <source>Pane</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>&amp;Pattern…</source>
        <translation>&amp;Muster…</translation>
    </message>
    <message>
        <source>&amp;Recipes…</source>
        <translation>&amp;Rezepte…</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>More values</source>
        <translation>Weitere Werte</translation>
    </message>
    <message>
        <source>Page before</source>
        <translation>Vorige Seite</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>Nächste Seite</translation>
    </message>
    <message>
        <source>Unnamed recipe</source>
        <translation>Ohne Rezeptnamen</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1, geändert</translation>
    </message>
</context>
<context>
    <name>arris::ui::ReliefPlot</name>
    <message>
        <source>time from A, s</source>
        <translation>Zeit ab A in s</translation>
    </message>
    <message>
        <source>distance L, mm</source>
        <translation>Abstand L, mm</translation>
    </message>
    <message>
        <source>relief
%1 mm</source>
        <translation>Freigang
%1 mm</translation>
    </message>
</context>
<context>
    <name>arris::ui::ResumeBar</name>
    <message>
        <source>a power failure, or Arris ended</source>
        <translation>einen Stromausfall oder das Beenden von Arris</translation>
    </message>
    <message>
        <source>Arris ended in a hold</source>
        <translation>das Beenden von Arris während eines Halts</translation>
    </message>
    <message>
        <source>a stop</source>
        <translation>einen Stopp</translation>
    </message>
    <message>
        <source>a fault</source>
        <translation>eine Störung</translation>
    </message>
    <message>
        <source>the emergency stop</source>
        <translation>den Not-Halt</translation>
    </message>
    <message>
        <source>its end from the terminal</source>
        <translation>das Beenden vom Terminal aus</translation>
    </message>
    <message>
        <source>Resume the job of %1: %2, pane %3 of %4, interrupted by %5?</source>
        <translation>Auftrag vom %1 fortsetzen: %2, Scheibe %3 von %4, unterbrochen durch %5?</translation>
    </message>
    <message>
        <source>Take it up</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Understood</source>
        <translation>Verstanden</translation>
    </message>
    <message>
        <source>Discard it for good</source>
        <translation>Endgültig verwerfen</translation>
    </message>
    <message>
        <source>The job that was broken off is being read and planned…</source>
        <translation>Der abgebrochene Auftrag wird gelesen und geplant …</translation>
    </message>
    <message>
        <source>Discard the job that was broken off? It cannot be resumed then.</source>
        <translation>Den abgebrochenen Auftrag verwerfen? Er kann dann nicht mehr fortgesetzt werden.</translation>
    </message>
    <message>
        <source>The job that was broken off cannot be resumed.</source>
        <translation>Der abgebrochene Auftrag kann nicht fortgesetzt werden.</translation>
    </message>
    <message>
        <source>The job that was broken off is not resumed; what is known of it is kept as %1.</source>
        <translation>Der abgebrochene Auftrag wird nicht fortgesetzt; was von ihm bekannt ist, bleibt als %1 erhalten.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbruch</translation>
    </message>
</context>
<context>
    <name>arris::ui::RunPage</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Feed override</source>
        <translation>Vorschub-Override</translation>
    </message>
    <message>
        <source>Lower feed override</source>
        <translation>Vorschub-Override senken</translation>
    </message>
    <message>
        <source>Higher feed override</source>
        <translation>Vorschub-Override erhöhen</translation>
    </message>
    <message>
        <source>◀ Back</source>
        <translation>◀ Schritt zurück</translation>
    </message>
    <message>
        <source>RESUME</source>
        <translation>FORTSETZEN</translation>
    </message>
    <message>
        <source>Keep it pressed until the ring is full.</source>
        <translation>Gedrückt halten, bis der Ring voll ist.</translation>
    </message>
    <message>
        <source>CYCLE START
where it was broken off</source>
        <translation>ZYKLUSSTART
an der Abbruchstelle</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tisch</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>To go</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschw.</translation>
    </message>
    <message>
        <source>To go: to the end of the line or arc that the wheel is on.</source>
        <translation>Rest: bis zum Ende der Geraden oder des Bogens, auf dem die Schleifscheibe ist.</translation>
    </message>
    <message>
        <source>%1 of %2 mm/min</source>
        <translation>%1 von %2 mm/min</translation>
    </message>
    <message>
        <source>%1 mm/min</source>
        <translation>%1 mm/min</translation>
    </message>
    <message>
        <source>Open a pattern on the page Job, or drop one here.</source>
        <translation>Ein Muster auf der Seite „Auftrag“ öffnen oder hierher ziehen.</translation>
    </message>
    <message>
        <source>Forward ▶</source>
        <translation>Schritt vor ▶</translation>
    </message>
    <message>
        <source>CYCLE START
keep pressed</source>
        <translation>ZYKLUSSTART
gedrückt halten</translation>
    </message>
    <message>
        <source>Done: %1 %
To grind: %2 mm
Time left: %3</source>
        <translation>Fertig: %1 %
Noch zu schleifen: %2 mm
Restzeit: %3</translation>
    </message>
</context>
<context>
    <name>arris::ui::SettingsPage</name>
    <message>
        <source>Set this code</source>
        <translation>Code setzen</translation>
    </message>
    <message>
        <source>Take the code away</source>
        <translation>Code entfernen</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>That of the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalierung</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Keypad on the screen</source>
        <translation>Tastenfeld am Bildschirm</translation>
    </message>
    <message>
        <source>At a touch</source>
        <translation>Bei Antippen</translation>
    </message>
    <message>
        <source>At a click too</source>
        <translation>Auch bei Klick</translation>
    </message>
    <message>
        <source>Scale, from the next start</source>
        <translation>Skalierung, ab dem nächsten Start</translation>
    </message>
    <message>
        <source>What is changed here counts from the next start of Arris.</source>
        <translation>Was hier geändert wird, gilt ab dem nächsten Start von Arris.</translation>
    </message>
    <message>
        <source>A code protects the machine&apos;s values and, in the recipe, the accelerations. The operator&apos;s values stay open.</source>
        <translation>Ein Code schützt die Werte der Maschine und im Rezept die Beschleunigungen. Die Werte des Bedieners bleiben offen.</translation>
    </message>
    <message>
        <source>This is not the code.</source>
        <translation>Das ist nicht der Code.</translation>
    </message>
    <message>
        <source>A code has %1 to %2 digits.</source>
        <translation>Ein Code hat %1 bis %2 Ziffern.</translation>
    </message>
    <message>
        <source>No code is set: all values are open.</source>
        <translation>Kein Code gesetzt: Alle Werte sind offen.</translation>
    </message>
    <message>
        <source>All values are open until they are locked or Arris starts again.</source>
        <translation>Alle Werte sind offen, bis sie gesperrt werden oder Arris neu startet.</translation>
    </message>
    <message>
        <source>Locked: enter the code to change the machine.</source>
        <translation>Gesperrt: Code eingeben, um die Maschine zu ändern.</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simuliert</translation>
    </message>
    <message>
        <source>LinuxCNC</source>
        <translation>LinuxCNC</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Lock the values now</source>
        <translation>Werte jetzt sperren</translation>
    </message>
</context>
<context>
    <name>arris::ui::SetupPage</name>
    <message>
        <source>Drives</source>
        <translation>Antriebe</translation>
    </message>
    <message>
        <source>Switch drives on</source>
        <translation>Antriebe einschalten</translation>
    </message>
    <message>
        <source>Home all axes</source>
        <translation>Alle Achsen referenzieren</translation>
    </message>
    <message>
        <source>Switch drives off</source>
        <translation>Antriebe ausschalten</translation>
    </message>
    <message>
        <source>Ways above the glass</source>
        <translation>Fahrten über dem Glas</translation>
    </message>
    <message>
        <source>Trace the outline at height</source>
        <translation>Umriss über Glas abfahren</translation>
    </message>
    <message>
        <source>Go to the park position</source>
        <translation>Parkposition anfahren</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Schnell</translation>
    </message>
    <message>
        <source>Simulated machine</source>
        <translation>Simulierte Maschine</translation>
    </message>
    <message>
        <source>Next: switch the drives on.</source>
        <translation>Als Nächstes: Antriebe einschalten.</translation>
    </message>
    <message>
        <source>Next: home all axes, so that their places are known.</source>
        <translation>Als Nächstes: alle Achsen referenzieren, damit ihre Positionen bekannt sind.</translation>
    </message>
    <message>
        <source>Next: load the job on the page Run.</source>
        <translation>Als Nächstes: Auftrag auf der Seite „Betrieb“ laden.</translation>
    </message>
    <message>
        <source>Ready for the cycle start on the page Run.</source>
        <translation>Bereit für den Zyklusstart auf der Seite „Betrieb“.</translation>
    </message>
    <message>
        <source>X %1   Y %2   Z %3 mm</source>
        <translation>X %1   Y %2   Z %3 mm</translation>
    </message>
    <message>
        <source>The places are not known yet.</source>
        <translation>Die Positionen sind noch nicht bekannt.</translation>
    </message>
    <message>
        <source>Drives and jog</source>
        <translation>Antriebe, Tippen</translation>
    </message>
    <message>
        <source>Origin and by hand</source>
        <translation>Nullpunkt, von Hand</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Tippbetrieb</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>Dauernd</translation>
    </message>
    <message>
        <source>Jog as long as a button is pressed</source>
        <translation>Tippen, solange eine Taste gedrückt ist</translation>
    </message>
    <message>
        <source>Jog by %1 mm</source>
        <translation>Um %1 mm tippen</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Jog enable on the panel held</source>
        <translation>Tippfreigabe am Bedienpult gehalten</translation>
    </message>
    <message>
        <source>Press the jog enable on the panel and keep it pressed: without it no axis is jogged.</source>
        <translation>Tippfreigabe am Bedienpult drücken und gedrückt halten: Ohne sie fährt keine Achse im Tippbetrieb.</translation>
    </message>
    <message>
        <source>An axis moves as long as its button is pressed.</source>
        <translation>Eine Achse fährt, solange ihre Taste gedrückt ist.</translation>
    </message>
    <message>
        <source>Each press moves an axis by %1 mm.</source>
        <translation>Jeder Druck bewegt eine Achse um %1 mm.</translation>
    </message>
    <message>
        <source>Nothing can be moved: %1</source>
        <translation>Nichts lässt sich bewegen: %1</translation>
    </message>
    <message>
        <source>Clear all faults</source>
        <translation>Alle Störungen beheben</translation>
    </message>
    <message>
        <source>Read the alarm above, remove its cause, acknowledge it.</source>
        <translation>Alarm oben lesen, Ursache beseitigen, quittieren.</translation>
    </message>
    <message>
        <source>Held: go on with RESUME on the page Run, or STOP.</source>
        <translation>Angehalten: auf der Seite „Betrieb“ FORTSETZEN oder STOPP drücken.</translation>
    </message>
    <message>
        <source>Something moves: until it ends nothing is moved from here.</source>
        <translation>Etwas fährt: Bis es endet, wird von hier nichts bewegt.</translation>
    </message>
</context>
<context>
    <name>arris::ui::TimeModel</name>
    <message>
        <source>Grinding, lead-in to lead-out</source>
        <translation>Schleifen, mit An- und Abfahrweg</translation>
    </message>
    <message>
        <source>Whole program</source>
        <translation>Ganzes Programm</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
</context>
<context>
    <name>arris::ui::WheelBar</name>
    <message>
        <source>Wheel back along its path</source>
        <translation>Schleifscheibe auf ihrer Bahn zurück</translation>
    </message>
    <message>
        <source>Wheel on along its path</source>
        <translation>Schleifscheibe auf ihrer Bahn vor</translation>
    </message>
</context>
<context>
    <name>arris::ui::WipeCover</name>
    <message>
        <source>The screen is locked for wiping: %1 s
FEED HOLD and STOP work whenever something moves.</source>
        <translation>Der Bildschirm ist zum Wischen gesperrt: %1 s
VORSCHUB HALT und STOPP wirken, wann immer sich etwas bewegt.</translation>
    </message>
</context>
</TS>
